// Meshes that are placed many times.
#include <array>
#include <chrono>

#include <gtest/gtest.h>

#include "tests/transport/scene_helpers.h"

namespace {

using transport::CompiledScene;
using transport::Ray;
using transport::Vec3f;

/// Spheres, translated, rotated, stretched and mirrored, of which some faces emit.
std::string spheres(const std::string& attributes, bool normals) {
  const std::string floor = test::quad("brdf diffuse kd=0.5", "(-5,-2,5) (5,-2,5) (5,-2,-5) (-5,-2,-5)");
  return floor + "def ball = " + test::sphere(attributes, 8, normals) +
         "begin transform translation (-1.5,0,0) begin use ball end "
         "transform scale (1,0.5,1) rotation (0.3,0.2,1) translation (1.5,0,0) begin "
         "transform scale (-1,1,1) begin use ball end end end";
}

TEST(Instance, IsMetWhereItsCopyWouldBe) {
  const std::string text = spheres("rgb (0.2,0.4,0.6) brdf ward sx=0.1 sy=0.3", true);
  const CompiledScene instanced = test::scene_of(text, test::copies_up_to(0));
  const CompiledScene copied = test::scene_of(text, test::copies_up_to(1'000'000));
  ASSERT_EQ(instanced.instance_count(), 2U);
  ASSERT_EQ(copied.instance_count(), 0U);
  EXPECT_EQ(instanced.triangle_count(), copied.triangle_count());
  int met = 0;
  for (int i = 0; i < 10'000; ++i) {
    const float x = -3 + 6 * (static_cast<float>(i % 100) + 0.5F) / 100;
    const float y = -1 + 2 * (static_cast<float>(i / 100) + 0.5F) / 100;
    const Ray ray{Vec3f(x, y, 5), Vec3f(0, 0, -1)};
    const auto a = instanced.intersect(ray);
    const auto b = copied.intersect(ray);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a || std::abs(a->position.z - b->position.z) > 0.01F) continue;  // a silhouette
    ++met;
    EXPECT_LT((a->position - b->position).length(), 1e-2F);
    EXPECT_GT(a->geometric_normal.dot(b->geometric_normal), 0.98F) << x << ", " << y;
    EXPECT_GT(a->shading_normal.dot(b->shading_normal), 0.999F);
    EXPECT_GT(a->tangent.normalized().dot(b->tangent.normalized()), 0.99F) << x << ", " << y;
    EXPECT_EQ(a->colour, b->colour);
  }
  EXPECT_GT(met, 3000);
}

TEST(Instance, RendersAsItsCopyDoes) {
  const std::string text = spheres("brdf diffuse kd=0.7 light rgb (1,2,3)", false);
  test::RenderSetup setup;
  setup.eye = Vec3f(0, 1, 6);
  setup.samples = 64;
  setup.background = 0.2F;
  const test::Estimate a =
      test::mean_radiance(test::render(test::scene_of(text, test::copies_up_to(0)), setup));
  const test::Estimate b =
      test::mean_radiance(test::render(test::scene_of(text, test::copies_up_to(1'000'000)), setup));
  EXPECT_GT(b.mean, 0.1);
  EXPECT_NEAR(a.mean, b.mean, 4 * (a.deviation + b.deviation));
  EXPECT_NEAR(a.mean, b.mean, 1e-3 * b.mean);
}

TEST(Instance, HasTheSurfacesOfItsScope) {
  const std::string mesh = test::sphere("rgb paint", 4, false);
  const CompiledScene scene =
      test::scene_of("def paint = rgb (1,0,0) ball = " + mesh + " def paint2 = rgb (0,1,0) begin use ball " +
                         "transform translation (3,0,0) begin use ball end end",
                     test::copies_up_to(0));
  ASSERT_EQ(scene.instance_count(), 2U);
  EXPECT_EQ(scene.intersect({Vec3f(3, 0, 9), Vec3f(0, 0, -1)})->colour, Vec3f(1, 0, 0));
}

TEST(Instance, TakesLittleMemoryAndTime) {
  constexpr int Count = 10'000;
  std::string text = "def ball = " + test::sphere("brdf diffuse", 50, true) + "begin ";
  for (int i = 0; i < Count; ++i) {
    text += fmt::format("transform translation ({},{},0) begin use ball end ", 3 * (i % 100), 3 * (i / 100));
  }
  text += "end";
  const auto start = std::chrono::steady_clock::now();
  const CompiledScene scene = test::scene_of(text, test::copies_up_to(10'000));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_EQ(scene.instance_count(), static_cast<std::size_t>(Count));
  EXPECT_EQ(scene.triangle_count(), Count * 9800U);
  EXPECT_LT(scene.bytes(), 5'000'000U);
  EXPECT_LT(seconds, 20) << "a copy of all triangles would take minutes";
  EXPECT_TRUE(scene.intersect({Vec3f(150, 150, 9), Vec3f(0, 0, -1)}));
}

}  // namespace
