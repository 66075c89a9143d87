// Irradiance where faces meet at an angle, and under nested transforms.
#include <numbers>

#include <gtest/gtest.h>

#include "grf/visit.h"
#include "tests/bake/bake_helpers.h"

namespace {

using bake::Bake;
using Imath::V3d;
using test::bake_settings;
using test::BakeScene;
using transport::Rgb;
using transport::Vec3f;

// A vertex on the ridge of a roof, with a third of the other side's angle on one side. Each side has the
// irradiance of Lambert's formula; the vertex has their angle-weighted mean.
TEST(Bake, WeighsFacesAtACreaseByTheirAngles) {
  const BakeScene scene(
      "begin mesh brdf diffuse kd=0 begin vertexs (0,0,0) (0,2,0) (-2,2,0) (0,-2,-2) end vertexs\n"
      "begin faces (0,1,2) (0,3,1) end faces end mesh\n"
      "light begin rgb (3,2,1) (0.5,-0.5,1.5) (0,1,0) (0.5,0,-0.5) end\n");
  const std::array corners = {V3d(0.5, -0.5, 1.5), V3d(0.5, 0.5, 1.5), V3d(1, 0.5, 1), V3d(1, -0.5, 1)};
  const double on_top = test::irradiance_of_polygon(V3d(0), V3d(0, 0, 1), corners);
  const double at_side = test::irradiance_of_polygon(V3d(0), V3d(1, 0, 0), corners);
  ASSERT_GT(on_top, 1.3 * at_side);
  const double expected = (45 * on_top + 135 * at_side) / (45 + 135);
  Bake bake(scene.compiled, scene.points, bake_settings(8192, 1));
  bake.run();
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(bake.irradiance(0)[k], (3 - k) * expected, 4e-3 * (3 - k) * expected);
  std::vector<bake::BakePoints::Point> points;
  scene.points.points_at(0, points);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0].cumulative_fraction, 0.25, 1e-6);
  EXPECT_EQ(points[1].cumulative_fraction, 1);
  const Vec3f normal = Vec3f(3, 0, 1).normalized();
  EXPECT_LT((bake::BakePoints::normal_of(points) - normal).length(), 1e-6F);
}

// One transform turns a square upright and translates it, and an outer one turns it to +x, so the order
// matters. The square ends up at x = -5, from (0,0) to (1,1) in y and z.
TEST(BakedScene, HoldsTheLightOfMeshesUnderTransformsInTransforms) {
  const std::string square = test::quad("brdf diffuse", "(0,0,0) (1,0,0) (1,1,0) (0,1,0)");
  const BakeScene scene(
      "transform rotation (0,0,1.57079633) begin transform rotation (1.57079633,0,0) "
      "translation (0,5,0) begin " +
      square + "end end light begin rgb (3,3,3) (-3,0.2,0.1) (0,0,0.7) (0,0.9,0) end\n");
  const std::array corners = {V3d(-3, 0.2, 0.1), V3d(-3, 0.2, 0.8), V3d(-3, 1.1, 0.8), V3d(-3, 1.1, 0.1)};
  const std::array places = {V3d(-5, 0, 0), V3d(-5, 1, 0), V3d(-5, 1, 1), V3d(-5, 0, 1)};
  for (const int directions : {0, 1}) {
    bake::BakeSettings settings = bake_settings(2048, 1);
    settings.directions = directions;
    Bake bake(scene.compiled, scene.points, settings);
    bake.run();
    const bake::BakedScene baked = bake::with_irradiance(scene.scene, bake);
    grf::SceneVisitor visitor;
    int meshes = 0;
    visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement&, const grf::Block&) {
      ++meshes;
      for (std::size_t i = 0; i < 4; ++i) {
        const double expected = 3 * test::irradiance_of_polygon(places[i], V3d(1, 0, 0), corners);
        grf::Colour value(0);
        if (directions == 0) {
          value = std::get<grf::Colour>((*mesh.irradiance)[i]);
        } else {
          const auto& list = std::get<std::vector<grf::DirectionalIrradiance>>((*mesh.irradiance)[i]);
          ASSERT_EQ(list.size(), 1U);
          value = list[0].irradiance;
          EXPECT_LT((list[0].direction - Vec3f(0, 0, 1)).length(), 1e-5F) << "as the mesh has its front";
        }
        EXPECT_NEAR(value.x, expected, 5e-3 * expected) << "vertex " << i;
      }
    };
    grf::visit(baked.scene, visitor);
    EXPECT_EQ(meshes, 1);
  }
}

}  // namespace
