#include "grf/summary.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/grf/reading.h"

namespace grf {
namespace {

/// The cube from (0, 0, 0) to (1, 1, 1), of six squares.
std::string cube(const std::string& attributes = {}, const std::string& last_face = "(0, 2, 3, 1)") {
  return "begin mesh " + attributes +
         " begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) (1, 1, 0) (0, 0, 1) (1, 0, 1) (0, 1, 1) (1, 1, 1) end "
         "begin faces (4, 5, 7, 6) (0, 1, 5, 4) (1, 3, 7, 5) (3, 2, 6, 7) (2, 0, 4, 6) " +
         last_face + " end faces end mesh\n";
}

Summary summary_of(const std::string& text) { return summarize(scene_of(text)); }

TEST(Summary, CountsAClosedCube) {
  const Summary summary = summary_of(cube());
  EXPECT_EQ(summary.meshes, 1U);
  EXPECT_EQ(summary.vertices, 8U);
  EXPECT_EQ(summary.faces, 6U);
  EXPECT_EQ(summary.triangles, 12U);
  EXPECT_EQ(summary.boundary_edges, 0U);
  EXPECT_EQ(summary.nonmanifold_edges, 0U);
  EXPECT_EQ(summary.lights, 0U);
  EXPECT_DOUBLE_EQ(summary.area, 6);
  EXPECT_EQ(summary.bounds, Box3f(Vec3f(0), Vec3f(1)));
}

TEST(Summary, FindsHolesAndFins) {
  EXPECT_EQ(summary_of(cube("", "")).boundary_edges, 4U);
  EXPECT_DOUBLE_EQ(summary_of(cube("", "")).area, 5);
  const Summary fin = summary_of(cube("", "(0, 2, 3, 1) (0, 1, 7)"));
  EXPECT_EQ(fin.nonmanifold_edges, 1U);
  EXPECT_EQ(fin.boundary_edges, 2U);
}

TEST(Summary, TakesVerticesAtOnePlaceForOne) {
  const std::string seam =
      "begin mesh begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) (1, 0, -0) (0, 1, 0) (1, 1, 0) end "
      "begin faces (0, 1, 2) (3, 5, 4) end end";
  EXPECT_EQ(summary_of(seam).boundary_edges, 4U);
}

TEST(Summary, IsInWorldUnits) {
  const Summary summary =
      summary_of("transform scale (2, 3, -1) translation (1, 0, 0) begin " + cube() + " end");
  EXPECT_DOUBLE_EQ(summary.area, 2 * (2 * 3 + 3 * 1 + 2 * 1));
  EXPECT_EQ(summary.bounds, Box3f(Vec3f(1, 0, -1), Vec3f(3, 3, 0)));
}

TEST(Summary, CountsAsOftenAsAThingIsPlaced) {
  const Summary summary = summary_of(cube() + "transform translation (5, 0, 0) begin " + cube() + " end");
  EXPECT_EQ(summary.meshes, 2U);
  EXPECT_EQ(summary.faces, 12U);
  EXPECT_DOUBLE_EQ(summary.area, 12);
  EXPECT_EQ(summary.bounds, Box3f(Vec3f(0), Vec3f(6, 1, 1)));
}

TEST(Summary, CountsLightsAndMeshesWithFacesThatEmit) {
  EXPECT_EQ(summary_of("light begin (0, 2, 0) (1, 0, 0) (0, 0, 1) end").lights, 1U);
  EXPECT_EQ(summary_of(cube("light rgb (1, 1, 1)")).lights, 1U);
  EXPECT_EQ(summary_of(cube("", "light rgb (1, 1, 1) (0, 2, 3, 1)")).lights, 1U);
  EXPECT_EQ(summary_of("begin mesh light rgb (1, 1, 1) begin vertexs end begin faces end end").lights, 0U);
}

TEST(Summary, IncludesAllCornersOfLights) {
  const Box3f bounds = summary_of("light begin (1, 2, 3) (1, 0, 0) (0, 0, -1) end").bounds;
  EXPECT_EQ(bounds, Box3f(Vec3f(1, 2, 2), Vec3f(2, 2, 3)));
}

TEST(Summary, CountsDefinitionsAndDifferentModelsOfFaces) {
  const Summary summary = summary_of(
      "def a = brdf ward b = brdf ward c = pdf diffuse begin " +
      cube("brdf a",
           "(0, 2, 3, 1) brdf ward (0, 2, 3, 1) brdf ward sx=1 (0, 2, 3, 1) pdf diffuse (0, 2, 3, 1)") +
      cube("brdf WARD") + "end");
  EXPECT_EQ(summary.brdfs, 4U);
  EXPECT_EQ(summary.pdfs, 2U);
  EXPECT_EQ(summary_of(triangle("brdf phong", "brdf ward")).brdfs, 1U) << "no face has the mesh's own";
}

TEST(Summary, OfNothingIsEmpty) {
  const Summary summary = summary_of("// nothing");
  EXPECT_EQ(summary.meshes, 0U);
  EXPECT_TRUE(summary.bounds.isEmpty());
}

TEST(AreaVector, IsRightForPolygonsThatAreNotConvex) {
  const Scene scene = scene_of(
      "begin mesh begin vertexs (0, 0, 0) (4, 0, 0) (4, 4, 0) (2, 1, 0) (0, 4, 0) end "
      "begin faces (0, 1, 2, 3, 4) (2, 3, 4, 0, 1) (3, 4, 0, 1, 2) end end");
  const Mesh& mesh = mesh_of(scene);
  for (std::size_t face = 0; face < 3; ++face) {
    EXPECT_EQ(doubled_area_vector(*mesh.geometry, face, Matrix44d()), Vec3d(0, 0, 20))
        << "starting at another corner";
  }
}

TEST(Summary, CountsDifferentImages) {
  const Scene scene = scene_of(
      "def a = texture \"a.png\" b = texture \"b.png\" begin begin mesh texture a begin vertexs (0, 0, 0) "
      "(1, 0, 0) (0, 1, 0) end vertexs begin faces (0, 1, 2) texture \"c.png\" (0, 1, 2) texture \"b.png\" "
      "(0, 1, 2) end faces end mesh end");
  EXPECT_EQ(summarize(scene).textures, 3U);
}

TEST(Summary, CountsInstancesAsMeshesToo) {
  const Summary summary = summary_of("def m = " + cube() + " unused = " + cube() + " begin use m " + cube() +
                                     "transform translation (5, 0, 0) begin use m end end");
  EXPECT_EQ(summary.meshes, 3U);
  EXPECT_EQ(summary.instances, 2U);
  EXPECT_EQ(summary.vertices, 24U);
  EXPECT_EQ(summary.faces, 18U);
  EXPECT_EQ(summary.triangles, 36U);
  EXPECT_DOUBLE_EQ(summary.area, 18);
  EXPECT_EQ(summary.bounds, Box3f(Vec3f(0), Vec3f(6, 1, 1)));
}

TEST(Summary, CountsInstancesThatEmitAsLights) {
  const Summary summary = summary_of("def m = " + cube("light rgb (1, 1, 1)") + " begin use m use m end");
  EXPECT_EQ(summary.lights, 2U);
}

TEST(Summary, CountsMeshLightsAsLightsWithTheirFaces) {
  const Summary summary = summary_of(
      "mesh light begin begin vertexs (0, 0, 2) (2, 0, 2) (2, 3, 2) (0, 3, 2) end begin faces (0, 1, 2, 3) "
      "end end");
  EXPECT_EQ(summary.lights, 1U);
  EXPECT_EQ(summary.meshes, 0U);
  EXPECT_EQ(summary.instances, 0U);
  EXPECT_EQ(summary.vertices, 4U);
  EXPECT_EQ(summary.faces, 1U);
  EXPECT_EQ(summary.triangles, 2U);
  EXPECT_EQ(summary.boundary_edges, 4U);
  EXPECT_DOUBLE_EQ(summary.area, 6);
  EXPECT_EQ(summary.bounds, Box3f(Vec3f(0, 0, 2), Vec3f(2, 3, 2)));
}

TEST(Summary, OfInstancesIsThatOfMeshesWrittenOut) {
  const std::string first =
      "transform rotation (0.3, -0.7, 2) scale (2, 3, -0.5) translation (1, 2, 3) begin ";
  const std::string second = "transform scale (2, 2, 2) rotation (1, 1, 1) begin ";
  const std::string third = "transform rotation (0, 0, 0.7853982) translation (0, 0, 1) begin ";
  const auto scene = [&](const std::string& mesh) {
    return mesh + first + mesh + second + mesh + "end end " + second + mesh + "end " + third + mesh + "end ";
  };
  const std::string mesh = cube("", "");
  const Summary instances = summary_of("def m = " + mesh + " begin " + scene("use m ") + "end");
  const Summary meshes = summary_of(scene(mesh));
  EXPECT_EQ(instances.instances, 5U);
  EXPECT_EQ(instances.meshes, meshes.meshes);
  EXPECT_EQ(instances.faces, meshes.faces);
  EXPECT_EQ(instances.boundary_edges, meshes.boundary_edges);
  EXPECT_EQ(instances.bounds, meshes.bounds);
  EXPECT_NEAR(instances.area, meshes.area, 1e-9 * meshes.area);
}

TEST(Summary, MeasuresInstancesUnderRotationsAndScalesThatAreNotUniform) {
  const auto area = [](const std::string& transform) {
    return summary_of("def m = " + cube() + " begin transform " + transform + " begin use m end end").area;
  };
  EXPECT_NEAR(area("scale (2, 3, 5)"), 2 * (6 + 15 + 10), 1e-9);
  EXPECT_NEAR(area("scale (2, 3, -5) rotation (1, 2, 3)"), 2 * (6 + 15 + 10), 1e-9);
  EXPECT_NEAR(area("rotation (1, 2, 3) scale (2, 2, 2)"), 24, 1e-9);
  // A square turned by an eighth is stretched to a rhombus.
  EXPECT_NEAR(area("rotation (0, 0, 0.78539816) scale (2, 1, 1)"), 2 * 2 + 4 * std::sqrt(2.5), 1e-6);
}

}  // namespace
}  // namespace grf
