// Watertightness of closed rooms, and invariance to distance and size.
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/transport/scene_helpers.h"

namespace {

using test::box;
using test::map_of;
using test::placed;
using transport::CompiledScene;
using transport::Ray;
using transport::Vec3f;

/// A point within a twentieth of the unit box's size from its centre.
template <class Uniform>
Vec3f near_centre(Uniform& uniform) {
  return {0.1F * uniform(), 0.1F * uniform(), 0.1F * uniform()};
}

/// A point on one of the unit box's edges, or one of its corners.
template <class Uniform>
Vec3f on_edge_or_corner(Uniform& uniform, int first_axis, bool is_corner) {
  Vec3f place(uniform(), uniform(), uniform());
  for (int k = 0; k < (is_corner ? 3 : 2); ++k) {
    float& component = place[(first_axis + k) % 3];
    component = component < 0 ? -1.0F : 1.0F;
  }
  return place;
}

auto uniform_numbers() {
  return [random = std::mt19937(7), distribution = std::uniform_real_distribution<float>(-1, 1)]() mutable {
    return distribution(random);
  };
}

struct Leaks {
  int through_edges = 0;
  int after_corners_or_edges = 0;  ///< of rays in any direction into the room that start there
  std::vector<Ray> through_corners;
};

/// Counts the rays to edges and corners of the unit box, and those that continue from there, that escape. The
/// map takes the unit box to the room.
Leaks leaks(const CompiledScene& scene, const grf::Matrix44d& map, int count) {
  auto uniform = uniform_numbers();
  Leaks leaks;
  for (int i = 0; i < count; ++i) {
    const bool is_corner = i % 2 == 1;
    const Vec3f target(grf::Vec3d(on_edge_or_corner(uniform, i / 2, is_corner)) * map);
    const Vec3f start(grf::Vec3d(near_centre(uniform)) * map);
    const Ray ray = {start, target - start};
    const auto point = scene.intersect(ray);
    if (!point) {
      if (is_corner)
        leaks.through_corners.push_back(ray);
      else
        ++leaks.through_edges;
      continue;
    }
    const Vec3f inside = (start - point->position).normalized();
    Vec3f direction(uniform(), uniform(), uniform());
    const Vec3f normal =
        point->geometric_normal.dot(inside) < 0 ? -point->geometric_normal : point->geometric_normal;
    if (direction.dot(normal) < 0) direction = -direction;
    const transport::Ray onwards = {point->origin_towards(direction), direction, point->id};
    if (scene.is_unoccluded(onwards) || !scene.intersect(onwards)) ++leaks.after_corners_or_edges;
  }
  return leaks;
}

/// The number of eight rays around this one, which pass its end at this many rounding errors of its length,
/// that escape.
int leaks_about(const CompiledScene& scene, const Ray& ray, float roundings) {
  const Vec3f axis = ray.direction.normalized();
  const Vec3f across = axis.cross(std::abs(axis.x) < 0.5F ? Vec3f(1, 0, 0) : Vec3f(0, 1, 0)).normalized();
  const Vec3f up = axis.cross(across);
  const float distance = roundings * 0x1p-24F * ray.direction.length();
  int leaks = 0;
  for (int i = 0; i < 8; ++i) {
    const float angle = static_cast<float>(i) * static_cast<float>(M_PI) / 4;
    const Vec3f shift = (across * std::cos(angle) + up * std::sin(angle)) * distance;
    if (!scene.intersect({ray.origin, ray.direction + shift})) ++leaks;
  }
  return leaks;
}

TEST(ClosedBox, LetsNoRayOut) {
  constexpr int Rays = 200'000;
  const std::array<std::array<Vec3f, 3>, 4> maps = {{{Vec3f(1), Vec3f(0), Vec3f(0)},
                                                     {Vec3f(1), Vec3f(0.3F, 0.5F, 0.7F), Vec3f(0.2F)},
                                                     {Vec3f(1e-6F), Vec3f(0.3F, 0.5F, 0.7F), Vec3f(0)},
                                                     {Vec3f(1e6F), Vec3f(0.3F, 0.5F, 0.7F), Vec3f(5e5F)}}};
  for (const auto& [scale, angles, offset] : maps) {
    const CompiledScene scene = test::scene_of(placed(box("brdf diffuse"), scale, angles, offset));
    const Leaks found = leaks(scene, map_of(scale, angles, offset), Rays);
    EXPECT_EQ(found.through_edges, 0) << scale << angles << offset;
    EXPECT_EQ(found.after_corners_or_edges, 0) << scale << angles << offset;
    EXPECT_TRUE(found.through_corners.empty()) << scale << angles << offset;
  }
}

// Embree decides for each edge on which side of it a ray passes, consistently for both of its triangles:
// nothing gets through an edge. But at a vertex that is far away for the size of its triangles, these
// decisions can contradict each other within rounding, so that a ray passes all edges of the vertex on the
// side where the next triangle is not. It has to aim at the vertex for that.
TEST(ClosedBox, OfGreatLengthHasHolesInItsCornersOfTheSizeOfRoundingAlone) {
  constexpr int Rays = 200'000;
  const Vec3f scale(1, 2, 30);
  const Vec3f angles(1, 2, 3);
  const CompiledScene scene = test::scene_of(placed(box("brdf diffuse"), scale, angles, Vec3f(7)));
  const Leaks found = leaks(scene, map_of(scale, angles, Vec3f(7)), Rays);
  EXPECT_EQ(found.through_edges, 0);
  EXPECT_EQ(found.after_corners_or_edges, 0);
  EXPECT_LT(found.through_corners.size(), Rays / 2 / 50);
  for (const Ray& ray : found.through_corners) ASSERT_EQ(leaks_about(scene, ray, 64), 0);
}

TEST(ClosedBox, LetsNoRayOutOfAnInstance) {
  const Vec3f angles(0.3F, 0.5F, 0.7F);
  const std::string far_one = placed("use room", Vec3f(1), Vec3f(0), Vec3f(10, 0, 0));
  const CompiledScene scene =
      test::scene_of("def room = " + box("brdf diffuse") + "begin " +
                         placed("use room", Vec3f(1, 2, 0.5F), angles, Vec3f(0.2F)) + far_one + "end",
                     test::copies_up_to(0));
  ASSERT_EQ(scene.instance_count(), 2U);
  const Leaks found = leaks(scene, map_of(Vec3f(1, 2, 0.5F), angles, Vec3f(0.2F)), 100'000);
  EXPECT_EQ(found.through_edges, 0);
  EXPECT_EQ(found.after_corners_or_edges, 0);
  EXPECT_TRUE(found.through_corners.empty());
}

double sphere_brightness(const Vec3f& centre, bool normals) {
  const CompiledScene scene =
      test::scene_of(placed(test::sphere("brdf diffuse kd=1", 24, normals), Vec3f(1), Vec3f(0), centre));
  test::RenderSetup setup;
  setup.background = 1;
  setup.samples = 8;
  transport::RenderSettings settings = test::settings_of(setup);
  settings.view.eye = grf::Vec3d(centre) + grf::Vec3d(0, 0, 4);
  settings.view.target = grf::Vec3d(centre);
  transport::Render render(scene, settings);
  render.run();
  return test::mean_radiance(render.film()).mean;
}

// In a white environment a white sphere is invisible, unless it shadows itself.
TEST(FarScene, HasNoShadowsOfItsOwn) {
  EXPECT_NEAR(sphere_brightness(Vec3f(0), false), 1, 1e-4);
  EXPECT_NEAR(sphere_brightness(Vec3f(1e6F, 0, -1e6F), false), 1, 1e-4);
  EXPECT_NEAR(sphere_brightness(Vec3f(1e9F), false), 1, 1e-4);
}

// Here the other sphere prevents the scene from being shifted.
TEST(FarScene, HasNoShadowsOfItsOwnWhereItCannotBeShifted) {
  const std::string sphere = test::sphere("brdf diffuse kd=1", 8, false);
  const CompiledScene scene =
      test::scene_of(sphere + placed(sphere, Vec3f(1000), Vec3f(0), Vec3f(1e6F, 1e6F, 0)));
  EXPECT_EQ(scene.origin(), grf::Vec3d(0));
  test::RenderSetup setup;
  setup.eye = Vec3f(1e6F, 1e6F, 4000);
  setup.target = Vec3f(1e6F, 1e6F, 0);
  setup.background = 1;
  setup.samples = 8;
  EXPECT_NEAR(test::mean_radiance(test::render(scene, setup)).mean, 1, 1e-4);
}

TEST(FarScene, IsTheSameAsTheNearOne) {
  const std::string sphere = test::sphere("brdf diffuse", 8, false);
  const CompiledScene near = test::scene_of(sphere);
  // A power of two, so that the shift itself is exact.
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

// Two opposite corners of a light do not determine the other two.
TEST(FarScene, IsMovedByTheBoxAroundARotatedLight) {
  const CompiledScene scene = test::scene_of("light begin (900,0,0) (1,50,0) (1,-50,0) end\n");
  EXPECT_EQ(scene.bounds().min, grf::Vec3d(900, -50, 0));
  EXPECT_EQ(scene.bounds().max, grf::Vec3d(902, 50, 0));
  EXPECT_EQ(scene.origin(), grf::Vec3d(0));
}

TEST(Ray, DoesNotMeetTheTriangleThatItLeaves) {
  const CompiledScene scene = test::scene_of(test::quad("brdf diffuse", "(0,0,0) (1,0,0) (1,1,0) (0,1,0)"));
  const auto point = scene.intersect({Vec3f(0.7F, 0.2F, 1), Vec3f(0, 0, -1)});
  ASSERT_TRUE(point);
  const Ray down{Vec3f(0.7F, 0.2F, 1), Vec3f(0, 0, -1)};
  EXPECT_TRUE(scene.intersect(down));
  EXPECT_FALSE(scene.intersect({down.origin, down.direction, point->id}));
  EXPECT_FALSE(scene.is_unoccluded(down));
  EXPECT_TRUE(scene.is_unoccluded({down.origin, down.direction, point->id}));
}

// Slivers and degenerate faces do no harm.
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
