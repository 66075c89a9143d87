// A floor under a lamp and an environment map together, either of which may be sampled.
#include <cmath>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/reflectance/albedo.h"
#include "tests/transport/scene_helpers.h"

namespace {

using image::Image;
using reflectance::Resampling;
using transport::EnvironmentMap;
using transport::Integrator;
using transport::RenderSettings;
using transport::Rgb;
using transport::Vec3f;

constexpr double HalfSide = 0.5;

/// A square lamp, parallel to the floor at height 1 above its centre, front down: in two halves, one dimmer
/// than the mean and the other brighter by the same amount.
std::string lamp_of(float radiance, float difference = 0) {
  return fmt::format(
      "light begin rgb ({0},{0},{0}) (-0.5,-0.5,1) (0,1,0) (0.5,0,0) end\n"
      "light begin rgb ({1},{1},{1}) (0,-0.5,1) (0,1,0) (0.5,0,0) end\n",
      radiance * (1 - difference), radiance * (1 + difference));
}

/// The cosine-weighted fraction of the hemisphere that the lamp covers: four times that of a square over its
/// corner (Howell, "A catalog of radiation heat transfer configuration factors", B-3).
double share_of_lamp() {
  const double s = HalfSide / std::sqrt(1 + HalfSide * HalfSide);
  return 4 / std::numbers::pi * s * std::atan(s);
}

std::string floor_of(const std::string& brdf) {
  return test::quad("brdf " + brdf, "(-0.01,-0.01,0) (0.01,-0.01,0) (0.01,0.01,0) (-0.01,0.01,0)");
}

/// The floor's centre, seen from beside the lamp.
RenderSettings settings_under(float map, int depth) {
  test::RenderSetup setup;
  setup.eye = Vec3f(4, 0, 1);
  setup.width = setup.height = 4;
  setup.samples = 1024;
  setup.depth = depth;
  setup.field_of_view = 0.01F;
  RenderSettings settings = test::settings_of(setup);
  settings.integrator.environment =
      std::make_shared<EnvironmentMap>(Image{4, 2, std::vector<Rgb>(8, Rgb(map))});
  return settings;
}

test::Estimate shown(const transport::CompiledScene& scene, const RenderSettings& settings) {
  transport::Render render(scene, settings);
  render.run();
  EXPECT_EQ(render.rejected_samples(), 0U);
  return test::mean_radiance(render.film());
}

const std::vector<std::optional<Resampling>> ResamplingOrNot = {{}, Resampling{16, 2}};

// The lamp hides part of the map: kd (map (1 - F) + lamp F). With a depth of 3 the path splits in two, but
// there is no other surface to hit.
TEST(LampAndMap, AddUpOnAMatteFloor) {
  const double f = share_of_lamp();
  for (const auto& [map, lamp] : {std::pair(1.0F, 20.0F), {3.0F, 0.5F}, {0.2F, 40.0F}, {1.0F, 3.0F}}) {
    const auto scene = test::scene_of(floor_of("diffuse kd=0.6") + lamp_of(lamp, 0.6F));
    const double expected = 0.6 * (map * (1 - f) + lamp * f);
    for (const int depth : {1, 3}) {
      for (const auto& resampling : ResamplingOrNot) {
        RenderSettings settings = settings_under(map, depth);
        settings.integrator.resampling = resampling;
        const test::Estimate estimate = shown(scene, settings);
        EXPECT_NEAR(estimate.mean, expected, 5 * estimate.deviation + 1e-3 * expected)
            << map << " and " << lamp << ", depth " << depth << ", resampling " << resampling.has_value();
        EXPECT_LT(estimate.deviation, 0.01 * expected);
      }
    }
  }
}

TEST(LampAndMap, AddUpForPathsThatMeetThemByChance) {
  const double f = share_of_lamp();
  const auto scene = test::scene_of(floor_of("diffuse kd=0.6") + lamp_of(3, 0.6F));
  RenderSettings settings = settings_under(1, 1);
  settings.integrator.integrator = Integrator::Naive;
  settings.integrator.secondary_rays = 16;
  settings.samples = 256;
  const test::Estimate estimate = shown(scene, settings);
  EXPECT_NEAR(estimate.mean, 0.6 * (1 - f + 3 * f), 5 * estimate.deviation);
  EXPECT_LT(estimate.deviation, 0.01);
}

// A lamp of the map's own radiance is indistinguishable from it: the floor shows its albedo, for any lobe.
TEST(LampAndMap, ShowTheAlbedoWhereTheyAreAlike) {
  for (const char* brdf : {"ward sx=0.2 sy=0.2 ks=0.5 kd=0.3", "phong n=100 ks=0.4 kd=0.6"}) {
    const auto scene = test::scene_of(floor_of(brdf) + lamp_of(1));
    const Vec3f u = Vec3f(4, 0, 1).normalized();
    const auto point = scene.intersect({Vec3f(4, 0, 1), -u});
    ASSERT_TRUE(point);
    const double expected = reflectance::mean(reflectance::albedo(*scene.reflector(*point->surface), u));
    for (const auto& resampling : ResamplingOrNot) {
      RenderSettings settings = settings_under(1, 3);
      settings.integrator.resampling = resampling;
      const test::Estimate estimate = shown(scene, settings);
      EXPECT_NEAR(estimate.mean, expected, 5 * estimate.deviation + 3e-3 * expected) << brdf;
      EXPECT_LT(estimate.deviation, 0.01 * expected) << brdf;
    }
  }
}

}  // namespace
