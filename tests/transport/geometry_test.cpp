// Closed rooms stay closed, and distance and size change nothing.
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/transport/scene_helpers.h"

namespace {

using transport::CompiledScene;
using transport::CompileSettings;
using transport::Ray;
using transport::Vec3f;

std::string box(const std::string& attributes) {
  return "begin mesh " + attributes +
         " begin vertexs (-1,-1,-1) (1,-1,-1) (1,1,-1) (-1,1,-1) (-1,-1,1) (1,-1,1) (1,1,1) (-1,1,1) "
         "end vertexs begin faces (0,1,2,3) (4,7,6,5) (0,4,5,1) (2,6,7,3) (0,3,7,4) (1,5,6,2) "
         "end faces end mesh ";
}

CompiledScene compiled(const std::string& text, std::size_t most_copied_triangles) {
  grf::Diagnostics diagnostics;
  CompileSettings settings;
  settings.most_copied_triangles = most_copied_triangles;
  return std::move(
      *transport::compile(grf::read_text(text, "test.grf", diagnostics).value(), diagnostics, settings));
}

/// How many of the rays to edges and corners of the unit box, and of those that they become there, get out.
/// The map takes the unit box to the room.
int leaks(const CompiledScene& scene, const grf::Matrix44d& map, int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(-1, 1);
  int leaks = 0;
  for (int i = 0; i < count; ++i) {
    Vec3f target(uniform(random), uniform(random), uniform(random));
    const int corner_axes = 2 + i % 2;  // an edge or a corner
    for (int k = 0; k < corner_axes; ++k) {
      float& component = target[(i + k) % 3];
      component = component < 0 ? -1.0F : 1.0F;
    }
    const Vec3f eye(0.1F * uniform(random), 0.1F * uniform(random), 0.1F * uniform(random));
    const Vec3f start(grf::Vec3d(eye) * map);
    const auto point = scene.intersect({start, Vec3f(grf::Vec3d(target) * map) - start});
    if (!point) {
      ++leaks;
      continue;
    }
    const Vec3f inside = (start - point->position).normalized();
    Vec3f direction(uniform(random), uniform(random), uniform(random));
    const Vec3f normal =
        point->geometric_normal.dot(inside) < 0 ? -point->geometric_normal : point->geometric_normal;
    if (direction.dot(normal) < 0) direction = -direction;
    if (scene.escapes({point->origin_towards(direction), direction, point->id}) ||
        !scene.intersect({point->origin_towards(direction), direction, point->id}))
      ++leaks;
  }
  return leaks;
}

grf::Matrix44d map_of(const Vec3f& scale, const Vec3f& angles, const Vec3f& offset) {
  using Kind = grf::TransformStep::Kind;
  return grf::matrix_of({{Kind::Scale, scale}, {Kind::Rotation, angles}, {Kind::Translation, offset}});
}

std::string placed(const std::string& what, const Vec3f& scale, const Vec3f& angles, const Vec3f& offset) {
  return fmt::format("transform scale ({},{},{}) rotation ({},{},{}) translation ({},{},{}) begin {} end ",
                     scale.x, scale.y, scale.z, angles.x, angles.y, angles.z, offset.x, offset.y, offset.z,
                     what);
}

TEST(ClosedBox, LetsNoRayOut) {
  constexpr int Rays = 100'000;
  const std::array<std::array<Vec3f, 3>, 5> maps = {{{Vec3f(1), Vec3f(0), Vec3f(0)},
                                                     {Vec3f(1), Vec3f(0.3F, 0.5F, 0.7F), Vec3f(0.2F)},
                                                     {Vec3f(1e-6F), Vec3f(0.3F, 0.5F, 0.7F), Vec3f(0)},
                                                     {Vec3f(1e6F), Vec3f(0.3F, 0.5F, 0.7F), Vec3f(5e5F)},
                                                     {Vec3f(1, 2, 30), Vec3f(1, 2, 3), Vec3f(7)}}};
  for (const auto& [scale, angles, offset] : maps) {
    const CompiledScene scene = test::scene_of(placed(box("brdf diffuse"), scale, angles, offset));
    // Embree misses a few of the rays that aim exactly at a corner of the long room.
    const int most = scale.x == scale.z ? 0 : Rays / 200;
    EXPECT_LE(leaks(scene, map_of(scale, angles, offset), Rays), most) << scale << angles << offset;
  }
}

TEST(ClosedBox, LetsNoRayOutOfAnInstance) {
  const Vec3f angles(0.3F, 0.5F, 0.7F);
  const std::string far_one = placed("use room", Vec3f(1), Vec3f(0), Vec3f(10, 0, 0));
  const CompiledScene scene =
      compiled("def room = " + box("brdf diffuse") + "begin " +
                   placed("use room", Vec3f(1, 2, 0.5F), angles, Vec3f(0.2F)) + far_one + "end",
               0);
  ASSERT_EQ(scene.instance_count(), 2U);
  EXPECT_EQ(leaks(scene, map_of(Vec3f(1, 2, 0.5F), angles, Vec3f(0.2F)), 100'000), 0);
}

double sphere_brightness(const Vec3f& centre, bool normals) {
  const CompiledScene scene =
      test::scene_of(placed(test::sphere("brdf diffuse kd=1", 24, normals), Vec3f(1), Vec3f(0), centre));
  test::Look look;
  look.background = 1;
  look.samples = 8;
  transport::RenderSettings settings = test::settings_of(look);
  settings.view.eye = grf::Vec3d(centre) + grf::Vec3d(0, 0, 4);
  settings.view.target = grf::Vec3d(centre);
  transport::Render render(scene, settings);
  render.run();
  return test::mean_radiance(render.film()).mean;
}

// In a white world a white sphere vanishes, unless it shadows itself.
TEST(FarScene, HasNoShadowsOfItsOwn) {
  EXPECT_NEAR(sphere_brightness(Vec3f(0), false), 1, 1e-4);
  EXPECT_NEAR(sphere_brightness(Vec3f(1e6F, 0, -1e6F), false), 1, 1e-4);
  EXPECT_NEAR(sphere_brightness(Vec3f(1e9F), false), 1, 1e-4);
}

// Here the other sphere keeps the scene from being moved.
TEST(FarScene, HasNoShadowsOfItsOwnWhereItCannotBeShifted) {
  const std::string sphere = test::sphere("brdf diffuse kd=1", 8, false);
  const CompiledScene scene =
      test::scene_of(sphere + placed(sphere, Vec3f(1000), Vec3f(0), Vec3f(1e6F, 1e6F, 0)));
  EXPECT_EQ(scene.origin(), grf::Vec3d(0));
  test::Look look;
  look.eye = Vec3f(1e6F, 1e6F, 4000);
  look.target = Vec3f(1e6F, 1e6F, 0);
  look.background = 1;
  look.samples = 8;
  EXPECT_NEAR(test::mean_radiance(test::render(scene, look)).mean, 1, 1e-4);
}

TEST(FarScene, IsTheSameAsTheNearOne) {
  const std::string sphere = test::sphere("brdf diffuse", 8, false);
  const CompiledScene near = test::scene_of(sphere);
  // A power of two, so that the shift itself rounds nothing.
  const Vec3f offset(1 << 20, 0, 1 << 21);
  const CompiledScene far = test::scene_of(placed(sphere, Vec3f(1), Vec3f(0), offset));
  EXPECT_EQ(near.origin(), grf::Vec3d(0));
  EXPECT_LT((far.origin() - grf::Vec3d(offset)).length(), 1);
  const Vec3f shift = far.to_local(grf::Vec3d(offset));
  for (const float x : {0.0F, 0.3F, 0.71F}) {
    const auto a = near.intersect({Vec3f(x, 0.2F, 5), Vec3f(0, 0, -1)});
    const auto b = far.intersect({Vec3f(x, 0.2F, 5) + shift, Vec3f(0, 0, -1)});
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    EXPECT_LT((a->position + shift - b->position).length(), 1e-6F);
    EXPECT_LT((a->geometric_normal - b->geometric_normal).length(), 1e-5F);
  }
}

TEST(Ray, DoesNotMeetTheTriangleThatItLeaves) {
  const CompiledScene scene = test::scene_of(test::quad("brdf diffuse", "(0,0,0) (1,0,0) (1,1,0) (0,1,0)"));
  const auto point = scene.intersect({Vec3f(0.7F, 0.2F, 1), Vec3f(0, 0, -1)});
  ASSERT_TRUE(point);
  const Ray down{Vec3f(0.7F, 0.2F, 1), Vec3f(0, 0, -1)};
  EXPECT_TRUE(scene.intersect(down));
  EXPECT_FALSE(scene.intersect({down.origin, down.direction, point->id}));
  EXPECT_FALSE(scene.escapes(down));
  EXPECT_TRUE(scene.escapes({down.origin, down.direction, point->id}));
}

// Slivers and faces without area harm nobody.
TEST(Triangles, MayBeSlivers) {
  const CompiledScene scene = test::scene_of(
      "begin mesh begin vertexs (0,0,0) (1000,1000,0) (1000,1000.01,0) (5,5,5) (5,5,5) (1,1,1) end vertexs "
      "begin "
      "faces (0,1,2) (3,4,5) (3,3,3) end faces end mesh");
  int met = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto point = scene.intersect({Vec3f(990, 990 + 2e-5F * static_cast<float>(i), 9), Vec3f(0, 0, -1)});
    if (!point) continue;
    ++met;
    EXPECT_NEAR(std::abs(point->geometric_normal.z), 1, 1e-5);
  }
  EXPECT_GT(met, 0);
}

}  // namespace
