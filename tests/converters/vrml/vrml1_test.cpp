// VRML 1.0: the state, its shapes, and how materials and normals are bound to them.
#include <cmath>

#include <gmock/gmock.h>

#include "grf/summary.h"
#include "grf/visit.h"
#include "tests/converters/vrml/vrml_reading.h"

namespace convert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using grf::Colour;
using grf::Vec2f;
using grf::Vec3f;

const std::string Points = "Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] }\n";
const std::string Faces = "IndexedFaceSet { coordIndex [ 0, 1, 2, -1, 0, 2, 3, -1 ] ";
const std::string Colours = "Material { diffuseColor [ 1 0 0, 0 1 0, 0 0 1, 1 1 1 ] }\n";

std::string binding(std::string_view value) {
  return "MaterialBinding { value " + std::string(value) + " }\n";
}

std::vector<std::string> materials_of(const grf::Mesh& mesh) {
  std::vector<std::string> materials;
  for (std::size_t i = 0; i < mesh.face_count(); ++i) materials.push_back(material_of(mesh, i));
  return materials;
}
std::vector<Colour> face_colours(const grf::Mesh& mesh) {
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < mesh.face_count(); ++i)
    colours.push_back(std::get<Colour>(*mesh.surface(i).colour));
  return colours;
}
std::vector<Colour> corner_colours(const grf::Mesh& mesh, std::size_t face) {
  std::vector<Colour> colours;
  for (const std::uint32_t vertex : mesh.face(face)) colours.push_back(mesh.geometry->colours[vertex]);
  return colours;
}

/// The centres of all meshes, rounded, and how many corners each has.
std::vector<Vec3f> centres_of(const Reading& reading) {
  std::vector<Vec3f> centres;
  EXPECT_TRUE(reading.scene.has_value()) << reading.text();
  if (!reading.scene) return centres;
  grf::SceneVisitor visitor;
  visitor.mesh = [&centres](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    grf::Box3d box;
    for (const Vec3f& position : mesh.geometry->positions)
      box.extendBy(grf::Vec3d(position) * placement.to_world);
    const grf::Vec3d centre = box.center();
    centres.emplace_back(
        Vec3f(grf::Vec3d(std::round(centre.x * 1e4), std::round(centre.y * 1e4), std::round(centre.z * 1e4)) /
              1e4) +
        Vec3f(0));
  };
  grf::visit(*reading.scene, visitor);
  return centres;
}

TEST(Vrml1, ReadsFacesOfTheStateBeforeThem) {
  const grf::Mesh mesh = mesh1("DEF it Separator { " + Points + Faces + "} }");
  EXPECT_EQ(mesh.name, "it");
  EXPECT_EQ(mesh.geometry->positions.size(), 4U);
  EXPECT_THAT(mesh.face(1), ElementsAre(0, 2, 3));
  EXPECT_THAT(read_vrml1(Faces + "}").text(), HasSubstr("the index 0 is of no coordinate: there are 0"));
}

TEST(Vrml1, ASeparatorKeepsItsStateToItself) {
  const Reading reading = read_vrml1(
      "Separator { Separator { Translation { translation 9 0 0 } Material { diffuseColor 1 0 0 } Cube {} }\n"
      "Group { Translation { translation 1 0 0 } } Cube {} \n"
      "TransformSeparator { Translation { translation 0 5 0 } DEF m Material {} Cube {} } Cube {}\n"
      "Transform { translation 0 0 1 scaleFactor 2 2 2 } Translation { translation 1 0 0 } Cube {} }");
  EXPECT_THAT(centres_of(reading),
              ElementsAre(Vec3f(9, 0, 0), Vec3f(1, 0, 0), Vec3f(1, 5, 0), Vec3f(1, 0, 0), Vec3f(3, 0, 1)));
  const auto meshes = meshes_of(*reading.scene);
  EXPECT_EQ(material_of(meshes[0], 0), "material");
  EXPECT_EQ(material_of(meshes[1], 0), "");
  EXPECT_EQ(material_of(meshes[3], 0), "m");
}

TEST(Vrml1, HasTransformsOfEachKind) {
  EXPECT_THAT(centres_of(read_vrml1(
                  "Rotation { rotation 0 0 1 1.57079633 } Translation { translation 2 0 0 } Cube {}")),
              ElementsAre(Vec3f(0, 2, 0)));
  EXPECT_THAT(centres_of(read_vrml1("Scale { scaleFactor 2 1 1 } Translation { translation 2 0 0 } Cube {}")),
              ElementsAre(Vec3f(4, 0, 0)));
  EXPECT_THAT(centres_of(read_vrml1("MatrixTransform { matrix 1 0 0 0 0 1 0 0 0 0 1 0 7.5 0 1 1 } Cube {}")),
              ElementsAre(Vec3f(7.5F, 0, 1)));
  EXPECT_THAT(centres_of(read_vrml1("Transform { center 1 0 0 rotation 0 0 1 3.14159265 } Cube {}")),
              ElementsAre(Vec3f(2, 0, 0)));
  EXPECT_THAT(read_vrml1("MatrixTransform { matrix 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1 } Cube {}").text(),
              HasSubstr("the last column of the matrix is 0 0 0 1"));
}

TEST(Vrml1, SwitchesAndLevels) {
  const std::string choices = " Translation { translation 1 0 0 } Cube {} Sphere {} }";
  EXPECT_THAT(centres_of(read_vrml1("Switch { whichChild -3" + choices)), ElementsAre(X, X));
  EXPECT_THAT(centres_of(read_vrml1("Switch { whichChild 1" + choices)), ElementsAre(Vec3f(0)));
  EXPECT_THAT(centres_of(read_vrml1("Switch { whichChild 0" + choices + "Cube {}")), ElementsAre(X))
      << "what is chosen acts on what follows";
  EXPECT_THAT(read_vrml1("Switch {" + choices + "Cube {}").text(),
              HasSubstr("3 choices of Switches were left out"));
  const Reading levels = read_vrml1("LOD { range [ 3 ] Cube {} Sphere {} } WWWAnchor { name \"a\" Cube {} }");
  EXPECT_EQ(centres_of(levels).size(), 2U);
  EXPECT_THAT(levels.text(), HasSubstr("1 level of an LOD was left out"));
  EXPECT_THAT(levels.text(), HasSubstr("1 link of a WWWAnchor was lost"));
}

TEST(Vrml1, InlinesFiles) {
  const test::TemporaryFolder folder;
  folder.add("b.wrl", "#VRML V2.0 utf8\n" + shape("Box {}"));
  const Reading reading = read_path(folder.add(
      "a.wrl",
      "#VRML V1.0 ascii\nSeparator { Translation { translation 0 3 0 } WWWInline { name \"b.wrl\" } }"));
  EXPECT_THAT(centres_of(reading), ElementsAre(Vec3f(0, 3, 0)));
}

TEST(Vrml1, UsesShapesAgainWhereTheirStateIsTheSame) {
  const Reading reading =
      read_vrml1("Separator { DEF s Separator { " + Points + "DEF f " + Faces +
                 "} } Translation { translation 2 0 0 } USE s Material { diffuseColor 1 0 0 } USE s }");
  EXPECT_EQ(centres_of(reading).size(), 3U);
  const grf::Summary summary = grf::summarize(*reading.scene);
  EXPECT_EQ(summary.instances, 2U) << "the third one has a material";
  EXPECT_EQ(definitions_of(*reading.scene).size(), 2U);
}

TEST(Vrml1, PassesOverOtherNodesAndUnknownFields) {
  const Reading reading = read_vrml1(
      "Separator { renderCulling AUTO Info { string \"x\" } PerspectiveCamera { position 0 0 1 } SpotLight "
      "{}\n"
      "Foo { fields [ SFString a, MFNode b ] a \"}\" b [ Bar { } ] DEF c Cube { } } FontStyle { style (BOLD "
      "| ITALIC) }\n"
      "AsciiText { string [ \"a\", \"b\" ] justification LEFT } IndexedLineSet { coordIndex [ 0, 1, -1 ] }\n"
      "ShapeHints { vertexOrdering COUNTERCLOCKWISE shapeType SOLID } Texture2 { filename wood.gif } USE c\n"
      "Cube { } }");
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  EXPECT_EQ(std::get<grf::Texture>(*meshes_of(*reading.scene)[0].surface(0).texture).file, "wood.gif");
  for (const std::string_view line :
       {"2 Foo nodes were skipped: the standard has no node of that name", "1 Info node was skipped",
        "1 camera was left out", "1 light was left out", "1 AsciiText node was skipped: GRF has only faces",
        "1 IndexedLineSet node was skipped"}) {
    EXPECT_THAT(reading.text(), HasSubstr(line));
  }
  EXPECT_THAT(read_vrml1("Cube { width }").text(),
              HasSubstr("model.wrl:2:14: error: found '}', expected a value"));
  EXPECT_THAT(read_vrml1("Cube { width (A B) }").text(), HasSubstr("found 'B', expected ')'"));
}

TEST(Vrml1Solids, HaveTheirSizesAndParts) {
  EXPECT_NEAR(volume_of(mesh1("Cube { width 1 height 2 depth 3 }")), 6, 1e-6);
  EXPECT_EQ(mesh1("Cylinder { parts SIDES }").face_count(), 32U);
  EXPECT_EQ(mesh1("Cylinder { parts (TOP | BOTTOM) }").face_count(), 2U);
  EXPECT_EQ(mesh1("Cylinder { parts ALL }").face_count(), 34U);
  EXPECT_EQ(mesh1("Cone { parts (SIDES) bottomRadius 2 }").face_count(), 32U);
  EXPECT_EQ(mesh1("Cone { }").face_count(), 33U);
  EXPECT_NEAR(mesh1("Sphere { radius 3 }").geometry->positions[0].y, -3, 1e-6);
  EXPECT_THAT(read_vrml1("Cube { width 0 }").text(), HasSubstr("is 0, expected more than 0"));
}

TEST(Vrml1Solids, HaveMaterialsOfTheirParts) {
  EXPECT_THAT(face_colours(mesh1(Colours + binding("PER_FACE") + "Cube {}")),
              ElementsAre(X, Y, Z, Colour(1), X, Y));
  const grf::Mesh cylinder = mesh1(Colours + binding("PER_PART") + "Cylinder {}");
  EXPECT_EQ(face_colours(cylinder)[31], X);
  EXPECT_EQ(face_colours(cylinder)[32], Y);
  EXPECT_EQ(face_colours(cylinder)[33], Z);
  EXPECT_EQ(material_of(mesh1(Colours + "Cylinder {}"), 33), "material_0");
  EXPECT_EQ(material_of(mesh1(Colours + binding("PER_PART") + "Sphere {}"), 0), "material_0");
}

TEST(Vrml1Materials, OfOneValue) {
  for (const std::string value : {"", "MaterialBinding { }", "MaterialBinding { value OVERALL }"}) {
    const Reading reading = read_vrml1(
        Points + "DEF m Material { diffuseColor 0.5 0 0 shininess 0.5 specularColor 0.1 0.1 0.1 }" + value +
        Faces + "}");
    ASSERT_TRUE(reading.scene.has_value()) << reading.text();
    EXPECT_THAT(materials_of(meshes_of(*reading.scene)[0]), ElementsAre("m", "m"));
    EXPECT_EQ(brdf_text(definitions_of(*reading.scene)[0]), "lewis n=16 ks=0.1 kd=(0.5, 0, 0)");
  }
}

TEST(Vrml1Materials, OfFaces) {
  EXPECT_THAT(face_colours(mesh1(Points + Colours + binding("PER_FACE") + Faces + "}")), ElementsAre(X, Y));
  EXPECT_THAT(face_colours(mesh1(Points + Colours + binding("PER_PART") + Faces + "}")), ElementsAre(X, Y));
  for (const std::string value : {"PER_FACE_INDEXED", "PER_PART_INDEXED"}) {
    EXPECT_THAT(face_colours(mesh1(Points + Colours + binding(value) + Faces + "materialIndex [ 2, 5 ] }")),
                ElementsAre(Z, Y))
        << "the first follows the last";
    EXPECT_THAT(face_colours(mesh1(Points + Colours + binding(value) + Faces + "materialIndex -1 }")),
                ElementsAre(X, Y));
  }
  EXPECT_THAT(
      read_vrml1(Points + Colours + binding("PER_FACE_INDEXED") + Faces + "materialIndex [ 0 ] }").text(),
      HasSubstr("the list 'materialIndex' has 1 index, too few"));
}

TEST(Vrml1Materials, OfFacesThatDifferInMoreThanTheirColour) {
  const std::string materials =
      "DEF m Material { diffuseColor [ 1 0 0, 0 1 0 ] specularColor [ 0.5 0.5 0.5 ] shininess [ 0, 0.5, 1 ] "
      "}";
  const Reading reading =
      read_vrml1(Points + materials + binding("PER_FACE_INDEXED") + Faces + "materialIndex [ 2, 1 ] }");
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  EXPECT_THAT(materials_of(meshes_of(*reading.scene)[0]), ElementsAre("m_2", "m_1"));
  for (const grf::Definition& definition : definitions_of(*reading.scene)) {
    EXPECT_EQ(brdf_text(definition), definition.name == "m_2" ? "lewis n=32 ks=0.5 kd=(0, 0.5, 0)"
                                                              : "lewis n=16 ks=0.5 kd=(0, 0.5, 0)");
  }
}

TEST(Vrml1Materials, OfCorners) {
  const grf::Mesh in_order =
      mesh1(Points + "Material { diffuseColor [ 1 0 0, 0 1 0, 0 0 1, 1 1 1, 0 0 0 ] }" +
            binding("PER_VERTEX") + Faces + "}");
  EXPECT_THAT(corner_colours(in_order, 0), ElementsAre(X, Y, Z));
  EXPECT_THAT(corner_colours(in_order, 1), ElementsAre(Colour(1), Colour(0), X));
  const grf::Mesh by_coordinate = mesh1(Points + Colours + binding("PER_VERTEX_INDEXED") + Faces + "}");
  EXPECT_THAT(corner_colours(by_coordinate, 1), ElementsAre(X, Z, Colour(1)));
  EXPECT_EQ(by_coordinate.geometry->positions.size(), 4U);
  const grf::Mesh by_index = mesh1(Points + Colours + binding("PER_VERTEX_INDEXED") + Faces +
                                   "materialIndex [ 1, 1, 1, -1, 0, 3, 2, -1 ] }");
  EXPECT_THAT(corner_colours(by_index, 1), ElementsAre(X, Colour(1), Z));
  const Reading reading =
      read_vrml1(Points + "Material { diffuseColor [ 1 0 0, 0 1 0 ] transparency [ 0, 1 ] }" +
                 binding("PER_VERTEX") + Faces + "}");
  EXPECT_THAT(reading.text(),
              HasSubstr("2 faces have one material: only the diffuse colours of those of their corners"));
  EXPECT_THAT(read_vrml1(binding("PER_CORNER") + Colours + "Cube {}").text(),
              HasSubstr("'PER_CORNER' is not a binding"));
}

TEST(Vrml1Normals, AreBound) {
  const std::string begin = Points + "Normal { vector [ 1 0 0, 0 1 0, 0 0 1, 0 0 -1, 0 -1 0, -1 0 0 ] }";
  const auto bound = [&](const std::string& value, const std::string& fields = "") {
    return mesh1(begin + "NormalBinding { value " + value + " } " + Faces + fields + "}");
  };
  EXPECT_THAT(normals_of(bound("DEFAULT"), 1), ElementsAre(X, Z, -Z));
  EXPECT_THAT(normals_of(bound("PER_VERTEX_INDEXED", "normalIndex [ 0, 0, 0, -1, 1, 2, 1, -1 ]"), 1),
              ElementsAre(Y, Z, Y));
  EXPECT_THAT(normals_of(bound("PER_VERTEX"), 1), ElementsAre(-Z, -Y, -X));
  EXPECT_THAT(normals_of(bound("PER_FACE"), 1), ElementsAre(Y, Y, Y));
  EXPECT_THAT(normals_of(bound("PER_FACE_INDEXED", "normalIndex [ 0, 2 ]"), 1), ElementsAre(Z, Z, Z));
  EXPECT_THAT(normals_of(bound("OVERALL"), 1), ElementsAre(X, X, X));
}

TEST(Vrml1Normals, AreMadeByTheCreaseAngleWhereThereAreTooFew) {
  EXPECT_THAT(normals_of(mesh1(Points + "Normal { vector [ 1 0 0 ] }" + Faces + "}"), 0),
              ElementsAre(Z, Z, Z));
  EXPECT_TRUE(mesh1(Points + "ShapeHints { creaseAngle 0 }" + Faces + "}").geometry->normals.empty());
  EXPECT_THAT(normals_of(mesh1(Points + "ShapeHints { vertexOrdering CLOCKWISE }" + Faces + "}"), 0),
              ElementsAre(-Z, -Z, -Z));
  EXPECT_THAT(
      read_vrml1(Points + "Normal { vector [ 1 0 0 ] }" + Faces + "normalIndex [ 0, 0, 0, -1, 0, 1, 0 ] }")
          .text(),
      HasSubstr("the index 1 in 'normalIndex' is of no value: there are 1"));
}

TEST(Vrml1Textures, HaveCoordinatesAndATransform) {
  const std::string begin = Points +
                            "Texture2 { filename \"a.png\" wrapS CLAMP }"
                            "TextureCoordinate2 { point [ 0 0, 1 0, 1 1, 0 1 ] }";
  const Reading reading = read_vrml1(begin + Faces + "}");
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  EXPECT_EQ(meshes_of(*reading.scene)[0].geometry->uvs[2], Vec2f(1, 1));
  EXPECT_THAT(reading.text(), HasSubstr("1 texture is repeated"));
  const grf::Mesh indexed = mesh1(begin + Faces + "textureCoordIndex [ 0, 3, 2, -1, 1, 1, 1 ] }");
  EXPECT_EQ(indexed.geometry->uvs[indexed.face(1)[0]], Vec2f(1, 0));
  const grf::Mesh moved =
      mesh1(begin + "Texture2Transform { center 1 0 scaleFactor 2 2 translation 0 5 }" + Faces + "}");
  EXPECT_EQ(moved.geometry->uvs[0], Vec2f(-1, 5)) << "scaled about the center, then moved";
  const grf::Mesh made = mesh1(Points + "Texture2 { filename \"a.png\" }" + Faces + "}");
  EXPECT_EQ(made.geometry->uvs[2], Vec2f(1, 1));
  const Reading pixels = read_vrml1("Texture2 { image 1 2 1 0xFF 0x00 } Cube {}");
  EXPECT_THAT(pixels.text(), HasSubstr("1 image of a Texture2 was left out"));
}

TEST(Vrml1Textures, MultiplyTheDiffuseColour) {
  const Reading reading =
      read_vrml1("Material { diffuseColor 0.5 0 0 } Texture2 { filename \"a.png\" } Cube {}");
  EXPECT_EQ(brdf_text(definitions_of(*reading.scene)[0]), "diffuse kd=(0.5, 0, 0)");
}

TEST(Vrml1Solids, LookOutside) {
  constexpr double Pi = 3.14159265358979;
  EXPECT_NEAR(volume_of(mesh1("Cube { width 1 height 2 depth 3 }")), 6, 1e-5);
  EXPECT_NEAR(volume_of(mesh1("Sphere { radius 2 }")), 32 * Pi / 3, 1);
  EXPECT_NEAR(volume_of(mesh1("Cylinder { radius 2 height 3 }")), 12 * Pi, 1);
  EXPECT_NEAR(volume_of(mesh1("Cone { bottomRadius 3 height 4 }")), 12 * Pi, 1);
}

}  // namespace
}  // namespace convert
