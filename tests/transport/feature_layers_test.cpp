#include "renderer/transport/integrators/feature_layers.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "renderer/reflectance/albedo.h"
#include "tests/transport/scene_helpers.h"

namespace {

using reflectance::Rgb;
using transport::Camera;
using transport::FeatureLayers;
using transport::Vec3f;
using transport::View;

constexpr int Pixels = 33;

View view_from(const Vec3f& eye) {
  View view;
  view.eye = eye;
  return view;
}

FeatureLayers layers_of(const std::string& scene, const View& view, int threads = 0) {
  return transport::feature_layers(test::scene_of(scene), view, Pixels, Pixels, 16, 3, threads);
}

TEST(FeatureLayersTest, AreThoseOfASphere) {
  const FeatureLayers layers = layers_of(
      test::sphere("rgb (0.5, 1, 1) brdf diffuse kd=(0.8, 0.4, 0.2)", 64, true), view_from({0, 0, 4}));
  const std::size_t centre = Pixels * Pixels / 2;
  const Rgb& albedo = layers.albedo.pixels[centre];
  for (const auto& [found, expected] : {std::pair(albedo.x, 0.4F), {albedo.y, 0.4F}, {albedo.z, 0.2F}}) {
    EXPECT_NEAR(found, expected, 1e-5F);
  }
  EXPECT_NEAR((layers.normal.pixels[centre] - Vec3f(0, 0, 1)).length(), 0, 0.02F);
  EXPECT_NEAR(layers.depth[centre], 3, 0.02F);
  EXPECT_EQ(layers.albedo.pixels[0], Rgb(0)) << "nothing is there";
  EXPECT_EQ(layers.normal.pixels[0], Rgb(0));
  EXPECT_EQ(layers.depth[0], std::numeric_limits<float>::infinity());
}

// The albedo of a lobe is an estimate: take its mean over pixels that see it at about the same angle.
TEST(FeatureLayersTest, EstimateTheAlbedoOfLobes) {
  const std::string quad = "(-9,-9,0) (9,-9,0) (9,9,0) (-9,9,0)";
  View view = view_from({0, 0, 100});
  view.field_of_view = 2;
  const FeatureLayers layers = layers_of(test::quad("brdf ward sx=0.3 ks=0.5 kd=0.2", quad), view);
  Vec3f mean(0);
  for (const Rgb& pixel : layers.albedo.pixels) mean += pixel / (Pixels * Pixels);
  const auto scene = test::scene_of(test::quad("brdf ward sx=0.3 ks=0.5 kd=0.2", quad));
  const auto point = scene.intersect({{0.1F, 0.2F, 5}, {0, 0, -1}});
  ASSERT_TRUE(point);
  const Rgb expected = reflectance::albedo(*scene.reflector(*point->surface), {0, 0, 1});
  EXPECT_NEAR(mean.x, expected.x, 0.005F);
}

TEST(FeatureLayersTest, MeasureDepthAlongTheView) {
  const std::string wall = test::quad("brdf diffuse", "(-99,-99,-2) (99,-99,-2) (99,99,-2) (-99,99,-2)");
  const FeatureLayers layers = layers_of(wall, view_from({0, 0, 5}));
  for (const float depth : layers.depth) EXPECT_NEAR(depth, 7, 1e-4F);
  View away = view_from({0, 0, 5});
  away.target = Vec3f(0, 0, 9);
  EXPECT_EQ(layers_of(wall, away).depth[0], std::numeric_limits<float>::infinity());
  View from_behind = view_from({0, 0, -9});
  from_behind.target = Vec3f(0, 0, -2);
  for (const Rgb& normal : layers_of(wall, from_behind).normal.pixels) {
    EXPECT_NEAR((normal - Vec3f(0, 0, -1)).length(), 0, 1e-5F) << "on the side of the eye";
  }
}

TEST(FeatureLayersTest, DoNotDependOnThreads) {
  const std::string scene = test::sphere("brdf ward sx=0.2 ks=0.5 kd=0.3", 16, true);
  const FeatureLayers one = layers_of(scene, view_from({1, 2, 4}), 1);
  const FeatureLayers three = layers_of(scene, view_from({1, 2, 4}), 3);
  EXPECT_EQ(one.albedo.pixels, three.albedo.pixels);
  EXPECT_EQ(one.normal.pixels, three.normal.pixels);
  EXPECT_EQ(one.depth, three.depth);
}

TEST(CameraTest, ItsMatricesAreItsRays) {
  std::mt19937 random(1);
  const auto uniform = [&](float least, float most) {
    return std::uniform_real_distribution<float>(least, most)(random);
  };
  View view;
  view.eye = Vec3f(1, 2, 3);
  view.target = Vec3f(-2, 1, 0.5F);
  view.up = Vec3f(0.1F, 1, 0.2F);
  view.field_of_view = 60;
  const Camera camera(view, 40, 25);
  EXPECT_NEAR(camera.screen_width(), 2 * std::tan(M_PI / 6) * 40 / 25, 1e-5);
  for (int i = 0; i < 100; ++i) {
    const float x = uniform(0, 40);
    const float y = uniform(0, 25);
    const transport::Ray ray = camera.ray(x, y);
    const Vec3f point = ray.origin + ray.direction * uniform(0.1F, 50);
    const Vec3f in_image = point * camera.world_to_image();  // Imath divides by w
    EXPECT_NEAR(in_image.x * 40, x, 1e-3);
    EXPECT_NEAR(in_image.y * 25, y, 1e-3);
    const Vec3f local = point * camera.world_to_camera();
    EXPECT_LT(local.z, 0);
    EXPECT_NEAR(local.length(), (point - view.eye).length(), 1e-3);
  }
  EXPECT_NEAR((view.target * camera.world_to_camera()).x, 0, 1e-5);
}

}  // namespace
