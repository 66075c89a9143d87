// The shapes, lamps and instances of exported scenes.
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/scene.h"
#include "tests/converters/renderers/exported_scene.h"

namespace convert {
namespace {

using grf::Vec3d;
using testing::HasSubstr;
using testing::Not;

double area_of(const std::vector<grf::Mesh>& meshes) {
  double area = 0;
  for (const grf::Mesh& mesh : meshes) area += grf::area_of(*mesh.geometry, {});
  return area;
}

double volume_of(const std::vector<grf::Mesh>& meshes) {
  double volume = 0;
  for (const grf::Mesh& mesh : meshes) volume += signed_volume(mesh);
  return volume;
}

TEST(RendererShapes, KeepAreaAndFrontsAlsoInAMirror) {
  for (const char* transform : {"scale (1, 2, 3)", "scale (-1, 2, 3) translation (10, 0, 0)",
                                "rotation (0.5, 1, 2) translation (1, 2, 3) scale (1, 1, 1)"}) {
    const ExportedScene scene(fmt::format("transform {} begin {} end", transform, cube()));
    const bool is_scaled = std::string(transform).find("3)") < 20;
    const double volume = is_scaled ? 48 : 8;
    const double area = is_scaled ? 8 * (2 + 3 + 6) : 24;
    for (const auto& meshes : {scene.pbrt_meshes(), scene.mitsuba_meshes()}) {
      EXPECT_NEAR(volume_of(meshes), volume, 1e-4) << transform;
      EXPECT_NEAR(area_of(meshes), area, 1e-4) << transform;
    }
  }
}

TEST(RendererShapes, AreOnePerSurfaceWithTheFacesInTheirOrder) {
  const ExportedScene scene(
      cube("brdf diffuse kd=0.5", {"", "rgb (1, 0, 0)", "rgb none", "", "rgb (1, 0, 0)", ""}));
  const std::vector<std::vector<Vec3d>> centres = {{{0, 0, -1}, {0, -1, 0}, {0, 1, 0}},
                                                   {{0, 0, 1}, {-1, 0, 0}, {1, 0, 0}}};
  for (const auto& meshes : {scene.pbrt_meshes(), scene.mitsuba_meshes()}) {
    ASSERT_EQ(meshes.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      ASSERT_EQ(meshes[i].face_count(), 6U);
      for (std::size_t face = 0; face < 6; ++face) {
        const Vec3d normal = grf::doubled_area_vector(*meshes[i].geometry, face, {}).normalized();
        EXPECT_LT((normal - centres[i][face / 2]).length(), 1e-6) << i << ' ' << face;
      }
    }
  }
  const auto& shapes = scene.pbrt().shapes;
  EXPECT_EQ(scene.pbrt().materials.at(shapes[0].material).rgb("reflectance"), Vec3d(0.5));
  EXPECT_EQ(scene.pbrt().materials.at(shapes[1].material).rgb("reflectance"), Vec3d(0.5, 0, 0));
  EXPECT_THAT(scene.pbrt_warnings(), HasSubstr("6 polygons were cut into triangles"));
  EXPECT_THAT(scene.mitsuba_warnings(), HasSubstr("1 mesh lost its name"));
}

TEST(RendererShapes, AreFlatWithoutNormals) {
  const ExportedScene scene(cube());
  EXPECT_TRUE(scene.pbrt_meshes().at(0).geometry->normals.empty());
  EXPECT_EQ(scene.mitsuba().all("shape").at(0).values.at("face_normals"), "true")
      << "Mitsuba would compute normals of vertices";
}

TEST(RendererShapes, KeepNormalsAndAreFlatWhereACornerLacksOne) {
  const ExportedScene scene(
      "transform scale (1, 2, 1) rotation (0, 0, 1.5707963) begin begin mesh begin vertexs\n"
      "normal (0, 0.6, 0.8) (0,0,0) normal (0, 0, 1) (1,0,0) normal (0, 0, 1) (1,1,0) (0,1,0)\n"
      "end vertexs begin faces (0,1,2) (0,2,3) end faces end mesh end");
  for (const auto& meshes : {scene.pbrt_meshes(), scene.mitsuba_meshes()}) {
    const grf::Mesh& mesh = meshes.at(0);
    ASSERT_EQ(mesh.face_count(), 2U);
    const auto normal = [&](std::size_t face, std::size_t corner) {
      return Vec3d(mesh.geometry->normals[mesh.face(face)[corner]]);
    };
    // By the inverse of the scale, then turned from y to -x.
    EXPECT_LT((normal(0, 0) - Vec3d(-0.3, 0, 0.8).normalized()).length(), 1e-6);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_LT((normal(1, k) - Vec3d(0, 0, 1)).length(), 1e-6);
  }
  EXPECT_FALSE(scene.mitsuba().all("shape").at(0).values.contains("face_normals"));
}

TEST(RendererLamps, HaveTheRadianceOfTheirFaces) {
  const ExportedScene scene(
      "light begin (0, 2, 0) (1, 0, 0) (0, 0, 1) rgb (4, 2, 1) end\n"
      "mesh light begin rgb (7, 8, 9) begin vertexs (0,0,0) (1,0,0) (0,1,0) end begin faces (0,1,2) end "
      "end\n" +
      cube("brdf diffuse kd=0.25 light rgb (0.5, 0.25, 0.125)"));
  const std::vector<Vec3d> radiances = {{4, 2, 1}, {7, 8, 9}, {0.5, 0.25, 0.125}};
  const std::vector<Vec3d> reflectances = {Vec3d(0), Vec3d(0), Vec3d(0.25)};
  ASSERT_EQ(scene.pbrt().shapes.size(), 3U);
  const auto shapes = scene.mitsuba().all("shape");
  for (std::size_t i = 0; i < 3; ++i) {
    const test::PbrtShape& shape = scene.pbrt().shapes[i];
    ASSERT_TRUE(shape.emission.has_value());
    EXPECT_EQ(shape.emission->rgb("L"), radiances[i]);
    EXPECT_FALSE(shape.emission->parameters.contains("scale"));
    EXPECT_FALSE(shape.emission->parameters.contains("twosided"));
    EXPECT_EQ(scene.pbrt().materials.at(shape.material).rgb("reflectance"), reflectances[i]);
    const auto& rgb = shapes[i].child("emitter").lists.at("radiance");
    EXPECT_EQ(Vec3d(rgb[0], rgb[1], rgb[2]), radiances[i]);
  }
  // Parallelograms shine towards edge1 x edge2.
  for (const auto& meshes : {scene.pbrt_meshes(), scene.mitsuba_meshes()}) {
    const Vec3d front = grf::doubled_area_vector(*meshes[0].geometry, 0, {});
    EXPECT_LT((front - Vec3d(0, -1, 0)).length(), 1e-6);
    EXPECT_NEAR(signed_volume(meshes[2]), 8, 1e-6);
  }
}

// The side to which a face emits is that of its winding, whatever the normals of its vertices are.
TEST(RendererLamps, HaveNoNormalsOfVertices) {
  const ExportedScene scene(
      "begin mesh light rgb (1, 1, 1) begin vertexs normal (0,0,-1) (0,0,0) normal (0,0,-1) (1,0,0) "
      "normal (0,0,-1) (0,1,0) (0,0,0) end begin faces (0,1,2) (0,1,3) end end");
  EXPECT_TRUE(scene.pbrt_meshes().at(0).geometry->normals.empty());
  EXPECT_EQ(scene.pbrt_meshes().at(0).face_count(), 1U) << "a face without area cannot be sampled";
  EXPECT_EQ(scene.mitsuba().all("shape").at(0).values.at("face_normals"), "true");
  EXPECT_THAT(scene.pbrt_warnings(), HasSubstr("2 faces that emit lost the normals"));
}

std::string instances_of(const std::string& attributes) {
  return "def thing = " + cube(attributes) +
         "begin transform scale (1, 2, 3) rotation (0.3, 0.5, 0.7) translation (4, 5, 6) begin use thing "
         "end\n"
         "transform scale (-1, 1, 1) translation (0, 9, 0) begin use thing end end";
}

TEST(RendererInstances, AreInstancesWithTheirTransforms) {
  const ExportedScene scene(instances_of("brdf diffuse kd=0.25"));
  grf::Matrix44d first = grf::matrix_of({{grf::TransformStep::Kind::Scale, {1, 2, 3}},
                                         {grf::TransformStep::Kind::Rotation, {0.3F, 0.5F, 0.7F}},
                                         {grf::TransformStep::Kind::Translation, {4, 5, 6}}});
  const Vec3d point(1, -1, 1);
  ASSERT_EQ(scene.pbrt().instances.size(), 2U);
  EXPECT_LT((point * scene.pbrt().instances[0].to_world - point * first).length(), 1e-5);
  EXPECT_LT((point * scene.pbrt().instances[1].to_world - Vec3d(-1, 8, 1)).length(), 1e-6);
  ASSERT_EQ(scene.pbrt().shapes.size(), 1U);
  EXPECT_EQ(scene.pbrt().shapes[0].object, scene.pbrt().instances[0].object);
  std::vector<test::MitsubaElement> instances;
  for (const test::MitsubaElement& shape : scene.mitsuba().all("shape")) {
    if (shape.type == "instance") instances.push_back(shape);
  }
  ASSERT_EQ(instances.size(), 2U);
  EXPECT_LT((point * instances[0].to_world() - point * first).length(), 1e-5);
  EXPECT_LT((point * instances[1].to_world() - Vec3d(-1, 8, 1)).length(), 1e-6);
  const grf::Mesh mesh = scene.mesh(scene.pbrt().shapes[0].shape.string("filename"));
  EXPECT_NEAR(signed_volume(mesh), 8, 1e-6) << "in the object's own space";
}

TEST(RendererInstances, ThatEmitAreShapesOfTheirOwn) {
  const ExportedScene scene(instances_of("light rgb (1, 2, 3)"));
  EXPECT_TRUE(scene.pbrt().instances.empty());
  for (const auto& meshes : {scene.pbrt_meshes(), scene.mitsuba_meshes()}) {
    ASSERT_EQ(meshes.size(), 2U);
    EXPECT_NEAR(signed_volume(meshes[0]), 48, 1e-3);
    EXPECT_NEAR(signed_volume(meshes[1]), 8, 1e-4);
  }
}

const std::string ColouredTriangles =
    "begin mesh brdf diffuse kd=0.5 rgb (1, 0.5, 1) begin vertexs rgb (1, 0, 0) (0,0,0) rgb (0, 1, 0) "
    "(1,0,0) "
    "rgb (0, 0, 1) (1,1,0) (0,1,0) (-1,1,0) end begin faces (0,1,2) (0,2,3) (0,3,4) end end";

/// Interpolates an image as pbrt does, with (0,0) at its lower left corner.
grf::Colour interpolated(const image::Image& image, const grf::Vec2f& uv) {
  const double x = double(uv.x) * image.width - 0.5;
  const double y = (1 - double(uv.y)) * image.height - 0.5;
  const auto at = [&](double column, double row) {
    return image.at(static_cast<int>(column) % image.width, static_cast<int>(row) % image.height);
  };
  const double left = std::floor(x + 1e-4);
  const double above = std::floor(y + 1e-4);
  const auto fx = static_cast<float>(x - left);
  const auto fy = static_cast<float>(y - above);
  return (at(left, above) * (1 - fx) + at(left + 1, above) * fx) * (1 - fy) +
         (at(left, above + 1) * (1 - fx) + at(left + 1, above + 1) * fx) * fy;
}

TEST(RendererColours, OfVerticesAreAnImageForPbrt) {
  const ExportedScene scene(ColouredTriangles);
  const test::PbrtShape& shape = scene.pbrt().shapes.at(0);
  ASSERT_TRUE(shape.own.has_value());
  const test::PbrtEntity& texture = scene.pbrt().textures.at(shape.own->string("reflectance"));
  EXPECT_EQ(texture.string("filter"), "bilinear");
  const image::Image image = scene.image(texture.string("filename"));
  const grf::Mesh mesh = scene.mesh(shape.shape.string("filename"));
  const std::vector<std::vector<grf::Colour>> colours = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                         {{1, 0, 0}, {0, 0, 1}, {1, 1, 1}},
                                                         {{1, 0, 0}, {1, 1, 1}, {1, 1, 1}}};
  ASSERT_EQ(mesh.face_count(), 3U);
  for (std::size_t face = 0; face < 3; ++face) {
    for (const grf::Vec2f& place : std::vector<grf::Vec2f>{{0, 0}, {1, 0}, {0, 1}, {0.2F, 0.3F}}) {
      const float a = place.x;
      const float b = place.y;
      const auto corners = mesh.face(face);
      const auto mix = [&](const auto& of) { return of(0) * (1 - a - b) + of(1) * a + of(2) * b; };
      const grf::Vec2f uv = mix([&](std::size_t k) { return mesh.geometry->uvs[corners[k]]; });
      const grf::Colour expected = mix([&](std::size_t k) { return colours[face][k]; });
      EXPECT_LT((interpolated(image, uv) - expected * grf::Colour(0.5F, 0.25F, 0.5F)).length(), 0.01F)
          << face << ' ' << a << ' ' << b;
    }
  }
}

TEST(RendererColours, OfVerticesAreAnAttributeForMitsuba) {
  const ExportedScene scene(ColouredTriangles);
  const test::MitsubaElement& bsdf = scene.mitsuba().child("bsdf").child("bsdf");
  EXPECT_EQ(bsdf.child("texture").type, "mesh_attribute");
  EXPECT_EQ(bsdf.child("texture").values.at("name"), "vertex_color");
  const std::string file = scene.mitsuba().child("shape").values.at("filename");
  EXPECT_THAT(test::bytes_of(scene.path(file)), HasSubstr("property float red\n"))
      << "Mitsuba takes bytes as encoded in sRGB";
  const grf::Mesh mesh = scene.mesh(file);
  EXPECT_EQ(mesh.geometry->colours[0], grf::Colour(0.5F, 0, 0));
  EXPECT_EQ(mesh.geometry->colours[1], grf::Colour(0, 0.25F, 0));
  EXPECT_EQ(mesh.geometry->colours[3], grf::Colour(0.5F, 0.25F, 0.5F));
}

TEST(RendererColours, OfVerticesHaveTheirMeanOnOtherBrdfs) {
  const ExportedScene scene(
      "begin mesh brdf minnaert k=0 kd=0.5 begin vertexs rgb (0.6, 0, 0) (0,0,0) rgb (0, 0.3, 0) (1,0,0) "
      "rgb (0, 0, 0.9) (1,1,0) end begin faces (0,1,2) end end");
  EXPECT_THAT(scene.pbrt_warnings(), HasSubstr("1 face that is not diffuse, or has a texture, has the mean"));
}

// In the plane of the face, u has to grow along the y axis cross the normal.
TEST(RendererTangents, OfAnisotropicBrdfsAreThoseOfOurs) {
  const ExportedScene scene(cube("brdf ward sx=0.1 sy=0.4 ks=0.3 kd=0.2"));
  for (const auto& meshes : {scene.pbrt_meshes(), scene.mitsuba_meshes()}) {
    const grf::Mesh& mesh = meshes.at(0);
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
      const auto corners = mesh.face(face);
      const auto place = [&](std::size_t k) { return Vec3d(mesh.geometry->positions[corners[k]]); };
      const auto uv = [&](std::size_t k) { return grf::Vec2d(mesh.geometry->uvs[corners[k]]); };
      const Vec3d expected = Vec3d(0, 1, 0).cross(grf::doubled_area_vector(*mesh.geometry, face, {}));
      if (expected.length() < 1e-6) continue;
      const grf::Vec2d ab = uv(1) - uv(0);
      const grf::Vec2d ac = uv(2) - uv(0);
      const Vec3d along = ((place(1) - place(0)) * ac.y - (place(2) - place(0)) * ab.y) / ab.cross(ac);
      EXPECT_LT((along - expected.normalized()).length(), 1e-4) << face;
    }
  }
}

}  // namespace
}  // namespace convert
