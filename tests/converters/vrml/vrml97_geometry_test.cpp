// The geometry nodes of VRML97.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "grf/summary.h"
#include "tests/converters/vrml/vrml_reading.h"

namespace convert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using grf::Colour;
using grf::Vec2f;
using grf::Vec3f;

grf::Mesh mesh_of_geometry(std::string_view geometry) { return mesh97(shape(geometry)); }
std::string error_of_geometry(std::string_view geometry) {
  const Reading reading = read_vrml97(shape(geometry));
  EXPECT_FALSE(reading.scene.has_value());
  return reading.text();
}

std::vector<Colour> colours_of(const grf::Mesh& mesh, std::size_t face) {
  std::vector<Colour> colours;
  for (const std::uint32_t vertex : mesh.face(face)) colours.push_back(mesh.geometry->colours[vertex]);
  return colours;
}
std::vector<Vec2f> uvs_of(const grf::Mesh& mesh, std::size_t face) {
  std::vector<Vec2f> uvs;
  for (const std::uint32_t vertex : mesh.face(face)) uvs.push_back(mesh.geometry->uvs[vertex]);
  return uvs;
}
Colour face_colour(const grf::Mesh& mesh, std::size_t face) {
  return std::get<Colour>(mesh.surface(face).colour.value());
}

TEST(VrmlFaceSet, SharesVerticesAndKeepsPolygons) {
  const grf::Mesh mesh = mesh_of_geometry(
      "IndexedFaceSet { coord Coordinate { point [ 0 0 0 2 0 0 2 2 0 1 0.5 0 0 2 0 ] } convex FALSE"
      " coordIndex [ 0 1 2 3 4 -1 4 3 2 ] }");
  EXPECT_EQ(mesh.geometry->positions.size(), 5U);
  ASSERT_EQ(mesh.face_count(), 2U);
  EXPECT_THAT(mesh.face(0), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(mesh.face(1), ElementsAre(4, 3, 2));
  EXPECT_TRUE(mesh.geometry->normals.empty()) << "faces are flat by default";
}

TEST(VrmlFaceSet, ThatIsClockwiseIsTurned) {
  const grf::Mesh mesh =
      mesh_of_geometry(square("ccw FALSE color Color { color [ 1 0 0 0 1 0 0 0 1 1 1 1 ] }"));
  EXPECT_THAT(corners_of(mesh, 0), ElementsAre(Vec3f(0), Vec3f(1, 1, 0), Vec3f(1, 0, 0)));
  EXPECT_THAT(colours_of(mesh, 0), ElementsAre(X, Z, Y));
}

TEST(VrmlFaceSet, IndicesOfNothingAreErrorsAtTheirPlace) {
  const std::string begin =
      "IndexedFaceSet {\n coord Coordinate { point [ 0 0 0 1 0 0 0 1 0 ] }\n coordIndex ";
  EXPECT_THAT(error_of_geometry(begin + "[ 0 1, 3 -1 ] }"),
              HasSubstr("model.wrl:4:20: error: the index 3 is of no coordinate: there are 3"));
  EXPECT_THAT(error_of_geometry(begin + "[ 0 1 -2 ] }"),
              HasSubstr("4:19: error: the index -2 is of no coordinate"));
  EXPECT_THAT(error_of_geometry(begin + "[ 0 1.5 2 ] }"), HasSubstr("4:17: error: the index 1.5"));
  EXPECT_THAT(error_of_geometry(begin + "[ 0 1 1e30 ] }"), HasSubstr("the index 1e+30"));
  EXPECT_THAT(error_of_geometry("IndexedFaceSet { coordIndex [ 0 1 2 ] }"), HasSubstr("there are 0"));
  EXPECT_THAT(error_of_geometry("IndexedFaceSet { coord Coordinate { point [ 0 0 0 1 ] } }"),
              HasSubstr("the field 'point' has 4 numbers, which is not a multiple of 3"));
  EXPECT_THAT(error_of_geometry("IndexedFaceSet { coord Normal {} }"),
              HasSubstr("found the node Normal in the field 'coord'"));
}

TEST(VrmlFaceSet, ShortFacesAreLeftOutAndShiftNothing) {
  const Reading reading = read_vrml97(shape(
      "IndexedFaceSet { coord Coordinate { point [ 0 0 0 1 0 0 0 1 0 ] } coordIndex [ 0 1 -1 0 1 2 -1 2 -1 ]"
      " colorPerVertex FALSE color Color { color [ 1 0 0 0 1 0 0 0 1 ] }"
      " normalIndex [ 0 0 -1 0 1 2 -1 0 -1 ] normal Normal { vector [ 1 0 0 0 1 0 0 0 1 ] } }"));
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const grf::Mesh mesh = meshes_of(*reading.scene)[0];
  ASSERT_EQ(mesh.face_count(), 1U);
  EXPECT_EQ(face_colour(mesh, 0), Colour(0, 1, 0));
  EXPECT_THAT(normals_of(mesh, 0), ElementsAre(X, Y, Z));
  EXPECT_THAT(reading.text(), HasSubstr("2 faces were left out: fewer than three corners"));
}

TEST(VrmlFaceSet, BindsNormals) {
  const std::string normals = "normal Normal { vector [ 1 0 0, 0 1 0, 0 0 1, 0 0 -1 ] } ";
  EXPECT_THAT(normals_of(mesh_of_geometry(square(normals)), 1), ElementsAre(X, Z, -Z));
  const grf::Mesh indexed = mesh_of_geometry(square(normals + "normalIndex [ 1 1 2 -1 0 0 1 -1 ]"));
  EXPECT_THAT(normals_of(indexed, 0), ElementsAre(Y, Y, Z));
  EXPECT_THAT(normals_of(indexed, 1), ElementsAre(X, X, Y));
  const grf::Mesh by_face = mesh_of_geometry(square(normals + "normalPerVertex FALSE"));
  EXPECT_THAT(normals_of(by_face, 0), ElementsAre(X, X, X));
  EXPECT_THAT(normals_of(by_face, 1), ElementsAre(Y, Y, Y));
  const grf::Mesh by_index = mesh_of_geometry(square(normals + "normalPerVertex FALSE normalIndex [ 2 2 ]"));
  EXPECT_THAT(normals_of(by_index, 1), ElementsAre(Z, Z, Z));
  EXPECT_EQ(by_index.geometry->positions.size(), 4U);
  EXPECT_THAT(normals_of(mesh_of_geometry(square(normals + "ccw FALSE")), 0), ElementsAre(X, Z, Y))
      << "they stay as they are given";
}

TEST(VrmlFaceSet, BindsColours) {
  const std::string colours = "color Color { color [ 1 0 0, 0 1 0, 0 0 1, 1 1 1 ] } ";
  EXPECT_THAT(colours_of(mesh_of_geometry(square(colours)), 1), ElementsAre(X, Z, Colour(1)));
  const grf::Mesh indexed = mesh_of_geometry(square(colours + "colorIndex [ 1 1 2 -1 0 0 1 ]"));
  EXPECT_THAT(colours_of(indexed, 1), ElementsAre(X, X, Y));
  const grf::Mesh by_face = mesh_of_geometry(square(colours + "colorPerVertex FALSE"));
  EXPECT_EQ(face_colour(by_face, 1), Y);
  EXPECT_TRUE(by_face.geometry->colours.empty());
  EXPECT_EQ(face_colour(mesh_of_geometry(square(colours + "colorPerVertex FALSE colorIndex [ 3 2 ]")), 1), Z);
  const Reading clamped = read_vrml97(shape(square("color Color { color [ 2 0 0, 0 -1 0, 0 0 1, 1 1 1 ] }")));
  EXPECT_THAT(clamped.text(), HasSubstr("2 colours of vertices or faces were clamped"));
}

TEST(VrmlFaceSet, BindsTextureCoordinates) {
  const std::string points = "texCoord TextureCoordinate { point [ 0 0, 0.5 0, 2 3, -1 0 ] } ";
  EXPECT_THAT(uvs_of(mesh_of_geometry(square(points)), 1),
              ElementsAre(Vec2f(0, 0), Vec2f(2, 3), Vec2f(-1, 0)));
  EXPECT_THAT(uvs_of(mesh_of_geometry(square(points + "texCoordIndex [ 0 0 1 -1 3 2 1 -1 ]")), 1),
              ElementsAre(Vec2f(-1, 0), Vec2f(2, 3), Vec2f(0.5F, 0)));
}

TEST(VrmlFaceSet, EmptyListsAreNone) {
  const grf::Mesh mesh = mesh_of_geometry(
      square("normal Normal { vector [ ] } normalIndex [ ] color Color { color [ ] } texCoord "
             "TextureCoordinate { }"));
  EXPECT_TRUE(mesh.geometry->normals.empty() && mesh.geometry->colours.empty() && mesh.geometry->uvs.empty());
}

TEST(VrmlFaceSet, TooFewValuesAreErrors) {
  EXPECT_THAT(error_of_geometry(square("normal Normal { vector [ 0 0 1 ] }")),
              HasSubstr("there is 1 value for 'normalIndex', too few for the faces"));
  EXPECT_THAT(error_of_geometry(square("color Color { color [ 0 0 1 ] } colorIndex [ 0 0 0 -1 0 0 ]")),
              HasSubstr("the list 'colorIndex' has 6 indices, too few for the faces"));
  EXPECT_THAT(error_of_geometry(
                  square("texCoord TextureCoordinate { point [ 0 1 ] }\ntexCoordIndex [ 0 0 0 -1 0 0 1 ]")),
              HasSubstr("model.wrl:3:30: error: the index 1 in 'texCoordIndex' is of no value: there are 1"));
  EXPECT_THAT(error_of_geometry(
                  square("normal Normal { vector [ 0 0 1 ] } normalPerVertex FALSE normalIndex [ 0 -1 ]")),
              HasSubstr("the index -1 in 'normalIndex'"));
}

/// Two squares with a common edge along y, the second one bent up by so many degrees.
std::string bent(double degrees, std::string_view fields) {
  const double angle = degrees * std::numbers::pi / 180;
  const std::string end = std::to_string(std::cos(angle)) + " Y " + std::to_string(std::sin(angle)) + " ";
  std::string low = end;
  std::string high = end;
  low.replace(low.find('Y'), 1, "0");
  high.replace(high.find('Y'), 1, "1");
  return "IndexedFaceSet { coord Coordinate { point [ -1 0 0 0 0 0 0 1 0 -1 1 0 " + low + high +
         "] } coordIndex [ 0 1 2 3 -1 1 4 5 2 -1 ] " + std::string(fields) + "}";
}

TEST(VrmlCreaseAngle, SmoothsAcrossEdgesOfLess) {
  const grf::Mesh smooth = mesh_of_geometry(bent(60, "creaseAngle 1.1"));
  EXPECT_EQ(smooth.geometry->positions.size(), 6U);
  const auto normals = normals_of(smooth, 0);
  EXPECT_EQ(normals[0], Z);
  EXPECT_LT((normals[1] - Vec3f(-0.5F, 0, std::sqrt(0.75F))).length(), 1e-6);
  EXPECT_EQ(normals_of(smooth, 1)[0], normals[1]);
  const grf::Mesh creased = mesh_of_geometry(bent(60, "creaseAngle 1.0"));
  EXPECT_TRUE(creased.geometry->normals.empty());
  EXPECT_EQ(creased.geometry->positions.size(), 6U);
  EXPECT_LT((normals_of(mesh_of_geometry(bent(60, "creaseAngle 1.1 ccw FALSE")), 0)[3] + normals[1]).length(),
            1e-6);
}

// Three sides of a box of 1, 2 and 3 meet at right angles, whatever their areas, and though one is cut in two
// there.
TEST(VrmlCreaseAngle, WeighsFacesByTheirAngle) {
  const grf::Mesh mesh = mesh_of_geometry(
      "IndexedFaceSet { creaseAngle 2 coord Coordinate { point [ 0 0 0, 1 0 0, 1 2 0, 0 2 0, 0 0 3, 1 0 3, 0 "
      "2 3 ] }"
      " coordIndex [ 0 3 2 1 -1 0 1 5 -1 0 5 4 -1 0 4 6 3 -1 ] }");
  const Vec3f normal = normals_of(mesh, 0)[0];
  EXPECT_LT((normal + Vec3f(1, 1, 1).normalized()).length(), 1e-6)
      << normal.x << ' ' << normal.y << ' ' << normal.z;
  EXPECT_EQ(normals_of(mesh, 2)[0], normal);
}

TEST(VrmlCreaseAngle, OfHalfATurnSmoothsEverything) {
  EXPECT_FALSE(mesh_of_geometry(bent(179.9, "creaseAngle 3.1416")).geometry->normals.empty());
  EXPECT_TRUE(mesh_of_geometry(bent(179.9, "creaseAngle 3")).geometry->normals.empty());
}

TEST(VrmlCreaseAngle, FacesWithoutAreaGetNoNormals) {
  const grf::Mesh mesh = mesh_of_geometry(
      "IndexedFaceSet { coord Coordinate { point [ 0 0 0 1 0 0 0 1 0 1 1 0 ] }"
      " coordIndex [ 0 1 2 -1 1 3 2 -1 0 0 1 ] creaseAngle 1 }");
  EXPECT_THAT(normals_of(mesh, 0), ElementsAre(Z, Z, Z));
  EXPECT_THAT(normals_of(mesh, 2), ElementsAre(Vec3f(0), Vec3f(0), Vec3f(0)));
}

TEST(VrmlSolids, AreClosedAndLookOutside) {
  struct Solid {
    std::string text;
    double area, volume;  // of the true solid
  };
  constexpr double Pi = std::numbers::pi;
  for (const Solid& solid :
       {Solid{"Box { size 1 2 3 }", 22, 6}, Solid{"Sphere { radius 2 }", 16 * Pi, 32 * Pi / 3},
        Solid{"Cylinder { radius 2 height 3 }", 20 * Pi, 12 * Pi},
        Solid{"Cone { bottomRadius 3 height 4 }", 24 * Pi, 12 * Pi}}) {
    const grf::Mesh mesh = mesh_of_geometry(solid.text);
    EXPECT_NEAR(area_of(mesh), solid.area, 0.02 * solid.area) << solid.text;
    EXPECT_NEAR(volume_of(mesh), solid.volume, 0.03 * solid.volume) << solid.text;
    EXPECT_LE(volume_of(mesh), solid.volume * 1.000001);
    const Reading reading = read_vrml97(shape(solid.text));
    EXPECT_EQ(grf::summarize(*reading.scene).boundary_edges, 0U) << solid.text;
    EXPECT_TRUE(mesh.geometry->uvs.empty());
  }
  EXPECT_EQ(mesh_of_geometry("Box {}").geometry->positions.size(), 8U);
  EXPECT_EQ(mesh_of_geometry("Sphere {}").geometry->positions.size(), 2U + 15 * 32);
  EXPECT_THAT(read_vrml97(shape("Cone {}") + shape("Sphere {}")).text(),
              HasSubstr("2 curved solids became polygons: they have 32 sides around"));
}

TEST(VrmlSolids, HaveNormalsOfTheirTrueShape) {
  const grf::Mesh sphere = mesh_of_geometry("Sphere { radius 2 }");
  for (std::size_t i = 0; i < sphere.geometry->positions.size(); ++i) {
    EXPECT_LT((sphere.geometry->normals[i] * 2.0F - sphere.geometry->positions[i]).length(), 1e-5);
  }
}

// The slope of a cone of radius 3 and height 4 looks 4 parts outwards and 3 parts up, and so it does at the
// apex, where each face looks to its middle.
TEST(VrmlSolids, ConesHaveNormalsOfTheirSlope) {
  const grf::Mesh cone = mesh_of_geometry("Cone { bottomRadius 3 height 4 bottom FALSE }");
  ASSERT_EQ(cone.face_count(), 32U);
  for (std::size_t i = 0; i < cone.face_count(); ++i) {
    const auto corners = corners_of(cone, i);
    const auto normals = normals_of(cone, i);
    ASSERT_EQ(corners.size(), 3U);
    Vec3f middle(0);
    for (const Vec3f& corner : corners) middle += Vec3f(corner.x, 0, corner.z);
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_apex = corners[k].y > 0;
      const Vec3f outwards = (is_apex ? middle : Vec3f(corners[k].x, 0, corners[k].z)).normalized();
      EXPECT_LT((normals[k] - (outwards * 0.8F + Y * 0.6F)).length(), 1e-5) << i << ' ' << k;
    }
  }
}

TEST(VrmlSolids, CylindersHaveNormalsOutwardsAndFlatEnds) {
  const grf::Mesh cylinder = mesh_of_geometry("Cylinder { radius 2 height 5 }");
  ASSERT_EQ(cylinder.face_count(), 34U);
  for (std::size_t i = 0; i < 32; ++i) {
    const auto corners = corners_of(cylinder, i);
    const auto normals = normals_of(cylinder, i);
    ASSERT_EQ(corners.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LT((normals[k] - Vec3f(corners[k].x, 0, corners[k].z) * 0.5F).length(), 1e-5) << i << ' ' << k;
    }
  }
  for (const std::size_t end : {32U, 33U}) {
    EXPECT_THAT(normals_of(cylinder, end), testing::Each(Vec3f(0))) << "it is as flat as it is";
  }
}

TEST(VrmlSolids, LeaveOutPartsThatAreNotThere) {
  EXPECT_EQ(mesh_of_geometry("Cylinder { top FALSE }").face_count(), 33U);
  EXPECT_EQ(mesh_of_geometry("Cylinder { side FALSE bottom FALSE }").face_count(), 1U);
  EXPECT_EQ(corners_of(mesh_of_geometry("Cylinder { side FALSE bottom FALSE height 6 }"), 0)[0].y, 3);
  EXPECT_EQ(mesh_of_geometry("Cone { side FALSE }").face_count(), 1U);
  EXPECT_THAT(error_of_geometry("Cone { side FALSE bottom FALSE }"), HasSubstr("the file has no faces"));
}

TEST(VrmlSolids, WrapTexturesFromTheBack) {
  const std::string texture = "texture ImageTexture { url \"a.png\" }";
  const grf::Mesh cylinder = mesh97(shape("Cylinder { radius 1 height 2 }", texture));
  const grf::Mesh sphere = mesh97(shape("Sphere { radius 1 }", texture));
  for (const grf::Mesh& mesh : {cylinder, sphere}) {
    bool has_front = false;
    for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
      const bool is_front = (mesh.geometry->positions[i] - Z).length() < 1e-6 ||
                            (mesh.geometry->positions[i] - Z - Y).length() < 1e-6;
      if (!is_front || mesh.geometry->uvs[i].y == 0) continue;  // not of a cap
      has_front = has_front || std::abs(mesh.geometry->uvs[i].x - 0.5F) < 1e-6F;
    }
    EXPECT_TRUE(has_front);
  }
  // Counter-clockwise seen from above, and upwards (VRML97, 6.42). At a pole all directions meet.
  for (std::size_t i = 0; i < sphere.geometry->positions.size(); ++i) {
    const Vec3f& p = sphere.geometry->positions[i];
    const Vec2f& uv = sphere.geometry->uvs[i];
    EXPECT_NEAR(uv.y, 1 - std::acos(std::clamp(double(p.y), -1.0, 1.0)) / std::numbers::pi, 1e-3);
    if (std::abs(p.y) > 0.999F) continue;
    const double turns = std::atan2(-p.x, -p.z) / (2 * std::numbers::pi) - uv.x;
    EXPECT_NEAR(turns, std::round(turns), 1e-5) << p;
  }
  const grf::Mesh box = mesh97(shape("Box {}", texture));
  EXPECT_THAT(uvs_of(box, 0), ElementsAre(Vec2f(0, 0), Vec2f(1, 0), Vec2f(1, 1), Vec2f(0, 1)));
  EXPECT_EQ(corners_of(box, 0)[2], Vec3f(1, 1, 1));
}

const std::string Grid =
    "ElevationGrid { xDimension 3 zDimension 2 xSpacing 2 zSpacing 3 height [ 0 1 2 0 1 2 ] ";

TEST(VrmlElevationGrid, LooksUp) {
  const grf::Mesh mesh = mesh_of_geometry(Grid + "}");
  ASSERT_EQ(mesh.face_count(), 2U);
  EXPECT_EQ(mesh.geometry->positions.size(), 6U);
  EXPECT_THAT(corners_of(mesh, 0),
              ElementsAre(Vec3f(0, 0, 0), Vec3f(0, 0, 3), Vec3f(2, 1, 3), Vec3f(2, 1, 0)));
  EXPECT_THAT(corners_of(mesh_of_geometry(Grid + "ccw FALSE }"), 0),
              ElementsAre(Vec3f(0, 0, 0), Vec3f(2, 1, 0), Vec3f(2, 1, 3), Vec3f(0, 0, 3)));
  EXPECT_FALSE(mesh_of_geometry(Grid + "creaseAngle 0.1 }").geometry->normals.empty()) << "it is plane";
}

TEST(VrmlElevationGrid, HasWhatBelongsToVerticesAndFaces) {
  const std::string colours = "color Color { color [ 1 0 0 0 1 0 0 0 1 1 1 1 0 0 0 1 1 0 ] } ";
  EXPECT_THAT(colours_of(mesh_of_geometry(Grid + colours + "}"), 0), ElementsAre(X, Colour(1), Colour(0), Y));
  EXPECT_EQ(face_colour(mesh_of_geometry(Grid + colours + "colorPerVertex FALSE }"), 1), Y);
  const std::string normals = "normal Normal { vector [ 1 0 0 0 1 0 0 0 1 1 0 0 1 0 0 1 0 0 ] } ";
  EXPECT_THAT(normals_of(mesh_of_geometry(Grid + normals + "}"), 1), ElementsAre(Y, X, X, Z));
  EXPECT_THAT(normals_of(mesh_of_geometry(Grid + normals + "normalPerVertex FALSE }"), 1),
              ElementsAre(Y, Y, Y, Y));
  const grf::Mesh textured = mesh97(shape(Grid + "}", "texture ImageTexture { url \"a.png\" }"));
  EXPECT_THAT(uvs_of(textured, 1), ElementsAre(Vec2f(0.5F, 0), Vec2f(0.5F, 1), Vec2f(1, 1), Vec2f(1, 0)));
  EXPECT_THAT(
      uvs_of(mesh_of_geometry(Grid + "texCoord TextureCoordinate { point [ 0 0 1 2 0 0 3 4 0 0 0 0 ] } }"),
             0),
      ElementsAre(Vec2f(0, 0), Vec2f(3, 4), Vec2f(0, 0), Vec2f(1, 2)));
}

TEST(VrmlElevationGrid, MustHaveAHeightForEachVertex) {
  EXPECT_THAT(error_of_geometry("ElevationGrid { xDimension 2000000000 zDimension 2000000000 height [ 1 ] }"),
              HasSubstr("the field 'height' has 1 number, expected 2000000000 times 2000000000"));
  EXPECT_THAT(error_of_geometry("ElevationGrid { xDimension 1.5 }"),
              HasSubstr("'xDimension' is a whole number"));
  EXPECT_THAT(error_of_geometry(Grid + "color Color { color [ 1 0 0 ] } }"),
              HasSubstr("'color' has 1 value, expected 6"));
  EXPECT_THAT(error_of_geometry("ElevationGrid { xDimension -1 zDimension -1 }"), HasSubstr("no faces"));
}

TEST(VrmlExtrusion, IsABoxByDefault) {
  const grf::Mesh mesh = mesh_of_geometry("Extrusion {}");
  EXPECT_EQ(mesh.face_count(), 6U);
  EXPECT_EQ(mesh.geometry->positions.size(), 8U);
  EXPECT_NEAR(volume_of(mesh), 4, 1e-6);
  EXPECT_NEAR(volume_of(mesh_of_geometry("Extrusion { ccw FALSE }")), -4, 1e-6);
  EXPECT_EQ(mesh_of_geometry("Extrusion { beginCap FALSE endCap FALSE }").face_count(), 4U);
  EXPECT_FALSE(mesh_of_geometry("Extrusion { creaseAngle 2 }").geometry->normals.empty());
}

TEST(VrmlExtrusion, FollowsItsSpine) {
  EXPECT_NEAR(volume_of(mesh_of_geometry("Extrusion { spine [ 0 0 0 0 2 0 ] scale [ 1 1 0.5 0.5 ] }")),
              2 * 4 * 1.75 / 3, 0.2);
  EXPECT_NEAR(volume_of(mesh_of_geometry("Extrusion { spine [ 1 0 0 4 0 0 ] scale 2 1 }")), 3 * 8, 1e-5);
  EXPECT_NEAR(volume_of(mesh_of_geometry("Extrusion { spine [ 0 0 0 0 -2 0 ] }")), 8, 1e-5);
  EXPECT_NEAR(area_of(mesh_of_geometry("Extrusion { spine [ 0 0 0 0 0 2 ] orientation 0 1 0 0.7853981634 }")),
              8 + 16, 1e-5);
  // About a corner, the cross-section stands on the line that halves its angle.
  const grf::Mesh bend =
      mesh_of_geometry("Extrusion { spine [ 0 0 0 0 9 0 9 9 0 ] crossSection [ 1 1 1 -1 -1 -1 -1 1 1 1 ] }");
  EXPECT_EQ(bend.face_count(), 10U);
  const auto on_line = [](const Vec3f& p) { return std::abs(p.x + p.y - 9) < 1e-5; };
  EXPECT_EQ(std::count_if(bend.geometry->positions.begin(), bend.geometry->positions.end(), on_line), 4);
  EXPECT_GT(volume_of(bend), 0);
}

// The spine bends to the right, and then to the left, where the axis of the bend points the other way. The
// standard keeps the cross-sections from turning over there. All of them stand upright on the plane of the
// spine, so that the solid is as thick as they are, over the outline that their ends make.
TEST(VrmlExtrusion, AlongASpineLikeAnSDoesNotTurnOver) {
  const grf::Mesh mesh = mesh_of_geometry(
      "Extrusion { spine [ 0 0 0, 0 2 0, 2 2 0, 2 4 0 ] crossSection [ 0.5 1, 0.5 -1, -0.5 -1, -0.5 1, 0.5 1 "
      "] }");
  const double d = 0.5 * std::sqrt(0.5);  // half of the width, on lines at 45 degrees
  const std::vector<grf::Vec2d> outline = {{0.5, 0}, {d, 2 - d},     {2 + d, 2 - d}, {2.5, 4},
                                           {1.5, 4}, {2 - d, 2 + d}, {-d, 2 + d},    {-0.5, 0}};
  double area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const grf::Vec2d& next = outline[(i + 1) % outline.size()];
    area += (outline[i].x * next.y - next.x * outline[i].y) / 2;
    for (const double z : {-1.0, 1.0}) {
      const auto is_there = [&](const Vec3f& p) {
        return (grf::Vec3d(p) - grf::Vec3d(outline[i].x, outline[i].y, z)).length() < 1e-6;
      };
      EXPECT_EQ(std::count_if(mesh.geometry->positions.begin(), mesh.geometry->positions.end(), is_there), 1)
          << i << ' ' << z;
    }
  }
  EXPECT_NEAR(volume_of(mesh), 2 * area, 1e-5);
  EXPECT_EQ(mesh.geometry->positions.size(), 16U);
  EXPECT_EQ(mesh.face_count(), 14U);
}

TEST(VrmlExtrusion, ThatIsClosedIsARing) {
  std::string spine;
  for (int i = 0; i <= 32; ++i) {
    const double angle = 2 * std::numbers::pi * (i % 32) / 32;
    spine += std::to_string(5 * std::cos(angle)) + " 0 " + std::to_string(5 * std::sin(angle)) + " ";
  }
  const std::string text = "Extrusion { beginCap FALSE endCap FALSE spine [ " + spine + " ] }";
  const Reading reading = read_vrml97(shape(text));
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const grf::Mesh mesh = meshes_of(*reading.scene)[0];
  EXPECT_EQ(mesh.geometry->positions.size(), 32U * 4);
  EXPECT_EQ(grf::summarize(*reading.scene).boundary_edges, 0U);
  EXPECT_NEAR(volume_of(mesh), 2 * std::numbers::pi * 5 * 4, 3);
}

TEST(VrmlExtrusion, ThatDegeneratesIsNoCrash) {
  EXPECT_THAT(error_of_geometry("Extrusion { spine [ 0 0 0 ] }"), HasSubstr("no faces"));
  EXPECT_THAT(error_of_geometry("Extrusion { spine [ ] crossSection [ ] }"), HasSubstr("no faces"));
  EXPECT_EQ(
      mesh_of_geometry("Extrusion { spine [ 0 0 0 0 0 0 0 0 0 ] scale [ ] orientation [ ] }").face_count(),
      10U);
  EXPECT_EQ(mesh_of_geometry("Extrusion { spine [ 0 0 0 1 0 0 0 0 0 1 0 0 ] crossSection [ 0 0 1 0 ] }")
                .face_count(),
            3U);
  std::string numbers;
  for (int i = 0; i < 3000; ++i) numbers += "0 0 0 1 2 3 ";
  EXPECT_THAT(error_of_geometry("Extrusion { spine [ " + numbers + "] crossSection [ " + numbers + "] }"),
              HasSubstr("error: with this Extrusion, the solids of the file have more than 5000000 faces"));
}

TEST(VrmlGeometry, TooLargeForFloatsIsAnError) {
  EXPECT_THAT(
      error_of_geometry("ElevationGrid { xDimension 3 zDimension 2 xSpacing 3e38 height [ 0 0 0 0 0 0 ] }"),
      HasSubstr("error: the shape is too large for floats"));
}

}  // namespace
}  // namespace convert
