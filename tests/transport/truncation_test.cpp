// The bias of truncated paths is compared with closed forms, and with images of all bounces.
#include "renderer/transport/truncation.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/image/image_error.h"
#include "tests/transport/scene_helpers.h"

namespace {

using transport::Render;
using transport::RenderSettings;
using transport::Rgb;
using transport::Truncation;

/// A closed room whose walls all emit 1, and reflect this fraction of light.
std::string glowing_room(double albedo) {
  std::string room = test::box(fmt::format("brdf diffuse kd={}", albedo));
  return room.insert(room.find("begin faces") + 11, " light rgb (1,1,1)");
}

/// A room with a lamp below its ceiling, of which the back wall is glossy.
std::string lit_room() {
  return test::box("brdf diffuse kd=0.7") +
         "light begin rgb (9,8,7) (-0.3,0.9,-0.3) (0.6,0,0) (0,0,0.6) end " +
         test::quad("brdf ward sx=0.2 sy=0.2 ks=0.5 kd=0.1",
                    "(-0.9,-0.9,-0.95) (0.9,-0.9,-0.95) (0.9,0.9,-0.95) (-0.9,0.9,-0.95)");
}

RenderSettings settings_of(int depth, int samples = 16) {
  test::RenderSetup setup;
  setup.eye = grf::Vec3f(0, 0, 0.9F);
  setup.field_of_view = 80;
  setup.width = setup.height = 24;
  setup.depth = depth;
  setup.samples = samples;
  return test::settings_of(setup);
}

image::Image image_of(const transport::CompiledScene& scene, const RenderSettings& settings) {
  Render render(scene, settings);
  render.run();
  return render.film().mean();
}

double rays_of(const transport::CompiledScene& scene, const RenderSettings& settings) {
  Render render(scene, settings);
  render.run();
  return static_cast<double>(render.ray_count());
}

// With albedo a, the light of k bounces is a^k everywhere.
TEST(Truncation, StandsForAllBouncesOfAGlowingRoom) {
  constexpr double Albedo = 0.6;
  constexpr int Depth = 6;
  const auto scene = test::scene_of(glowing_room(Albedo));
  const auto truncations = truncations_of(scene, settings_of(Depth));
  ASSERT_EQ(truncations.size(), Depth - 1U);
  const double all = (1 - std::pow(Albedo, Depth + 1)) / (1 - Albedo);
  for (const Truncation& truncation : truncations) {
    const double factor = (1 - std::pow(Albedo, Depth - truncation.depth + 1)) / (1 - Albedo);
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(truncation.last_bounce_factor[channel], factor, 0.02 * factor) << truncation.depth;
    }
    EXPECT_LT(truncation.bias.high, 0.01) << truncation.depth;
    RenderSettings settings = settings_of(Depth, 64);
    follow(truncation, settings);
    Render render(scene, settings);
    render.run();
    const test::Estimate mean = test::mean_radiance(render.film());
    EXPECT_NEAR(mean.mean, all, 4 * mean.deviation + 0.005 * all) << truncation.depth;
  }
  EXPECT_EQ(truncation_for(truncations, 0.05)->depth, 1);
}

/// The squared error of images against others, from two of each, so that noise has no part in its mean.
double relmse_of(const std::array<image::Image, 2>& images, const std::array<image::Image, 2>& truths) {
  double sum = 0;
  const std::size_t pixels = images[0].pixels.size();
  for (std::size_t i = 0; i < pixels; ++i) {
    for (int c = 0; c < 3; ++c) {
      const std::array<double, 2> truth = {truths[0].pixels[i][c], truths[1].pixels[i][c]};
      const double mean = (truth[0] + truth[1]) / 2;
      sum += (double(images[0].pixels[i][c]) - truth[0]) * (double(images[1].pixels[i][c]) - truth[1]) /
             (mean * mean + image::RelmseFloor);
    }
  }
  return sum / (3.0 * static_cast<double>(pixels));
}

/// Two images with different seeds.
std::array<image::Image, 2> images_of(const transport::CompiledScene& scene, RenderSettings settings,
                                      std::uint32_t seed) {
  settings.seed = seed;
  const image::Image first = image_of(scene, settings);
  settings.seed = seed + 1;
  return {first, image_of(scene, settings)};
}

TEST(Truncation, StatesTheBiasThatImagesHave) {
  const auto scene = test::scene_of(lit_room());
  const auto truncations = truncations_of(scene, settings_of(5));
  ASSERT_EQ(truncations.size(), 4U);
  const auto truths = images_of(scene, settings_of(5, 256), 1);
  for (const Truncation& truncation : truncations) {
    RenderSettings truncated = settings_of(5, 256);
    follow(truncation, truncated);
    const double error = std::sqrt(std::max(0.0, relmse_of(images_of(scene, truncated, 10), truths)));
    EXPECT_GE(error, 0.9 * truncation.bias.low) << truncation.depth;
    EXPECT_LT(error, 1.1 * truncation.bias.high) << truncation.depth;
  }
  EXPECT_LT(truncations.back().bias.high, 0.05);
  EXPECT_GT(truncations.front().bias.low, 0) << "light of one bounce is no image of the others";
  EXPECT_LT(truncations.back().bias.error, truncations.front().bias.error);
}

// The lamp shines up, and the eye sees the floor.
TEST(Truncation, KeepsTheBouncesThatLightNeeds) {
  const std::string floor = test::quad("brdf diffuse kd=0.5", "(-3,0,3) (3,0,3) (3,0,-3) (-3,0,-3)");
  const std::string ceiling = test::quad("brdf diffuse kd=0.5", "(-3,4,-3) (3,4,-3) (3,4,3) (-3,4,3)");
  const std::string lamp = "light begin rgb (900,900,900) (-1,3,-1) (0,0,2) (2,0,0) end ";
  const auto scene = test::scene_of(floor + ceiling + lamp);
  RenderSettings settings = test::settings_of(test::floor_setup(24, 24, 16));
  settings.view.eye = grf::Vec3d(0, 2, 0.5);
  settings.integrator.depth = 2;
  EXPECT_FALSE(truncation_for(truncations_of(scene, settings), 2));
  settings.integrator.depth = 6;
  const auto truncations = truncations_of(scene, settings);
  EXPECT_NEAR(truncations.front().bias.error, 1, 0.1) << "the image would be black";
  EXPECT_TRUE(std::isinf(truncations.front().cost(2)));
  ASSERT_TRUE(truncation_for(truncations, 2));
  EXPECT_GE(truncation_for(truncations, 2)->depth, 2);
  EXPECT_FALSE(truncation_for(truncations, 1e-6));
}

TEST(Truncation, SavesRaysWhereMoreBouncesAreAskedForThanCount) {
  const auto scene = test::scene_of(lit_room());
  const auto truncation = truncation_for(truncations_of(scene, settings_of(24)), 0.2);
  ASSERT_TRUE(truncation);
  EXPECT_LT(truncation->cost(0.2), 0.9);
  RenderSettings truncated = settings_of(24, 64);
  follow(*truncation, truncated);
  EXPECT_NEAR(rays_of(scene, truncated) / rays_of(scene, settings_of(24, 64)), truncation->rays, 0.03);
}

// The bias leaves sqrt(1 - 1/16) of the target to noise. Errors fall as samples^-0.74.
TEST(Truncation, CostsTheSamplesThatNoiseBesideTheBiasNeeds) {
  const Truncation truncation{1, Rgb(1), {0.01, 0.01, 0.01}, 0.5, 2};
  EXPECT_NEAR(truncation.cost(0.04), 0.5 * std::pow(2 / (1 - 1.0 / 16), 1 / 1.48), 1e-6);
  EXPECT_TRUE(std::isinf(truncation.cost(0.039)));
  EXPECT_EQ(transport::truncation_for({truncation}, 0.04)->depth, 1);
  EXPECT_FALSE(transport::truncation_for({}, 0.04));
}

TEST(Truncation, DoesNotDependOnThreads) {
  const auto scene = test::scene_of(lit_room());
  RenderSettings settings = settings_of(4);
  settings.threads = 1;
  const auto of_one = truncations_of(scene, settings);
  settings.threads = 3;
  const auto of_three = truncations_of(scene, settings);
  ASSERT_EQ(of_one.size(), of_three.size());
  for (std::size_t i = 0; i < of_one.size(); ++i) {
    EXPECT_EQ(of_one[i].last_bounce_factor, of_three[i].last_bounce_factor);
    EXPECT_EQ(of_one[i].bias.high, of_three[i].bias.high);
  }
}

TEST(Truncation, IsOfPathsOfSeveralBouncesAlone) {
  const auto scene = test::scene_of(lit_room());
  EXPECT_TRUE(truncations_of(scene, settings_of(1)).empty());
  RenderSettings settings = settings_of(4);
  settings.integrator.integrator = transport::Integrator::Naive;
  EXPECT_TRUE(truncations_of(scene, settings).empty());
}

TEST(Bias, IsPartOfTheStatedError) {
  const auto sum = transport::with_bias({4, 3, 12}, {3, 4, 5});
  EXPECT_DOUBLE_EQ(sum.error, 5);
  EXPECT_DOUBLE_EQ(sum.low, 5);
  EXPECT_DOUBLE_EQ(sum.high, 13);
  const auto scene = test::scene_of(lit_room());
  RenderSettings settings = settings_of(3, RenderSettings::Unlimited);
  settings.target_error = 0.05;
  settings.bias = {0.03, 0.03, 0.03};
  Render render(scene, settings);
  render.run();
  EXPECT_EQ(render.end(), transport::RenderEnd::TargetError);
  const double noise = render.film().error_estimate()->error;
  EXPECT_LT(noise, 0.0401);
  EXPECT_NEAR(render.error_estimate()->error, std::hypot(noise, 0.03), 1e-9);
  EXPECT_NEAR(*render.progress().estimated_error, std::hypot(noise, 0.03), 0.01);
}

TEST(Bias, IsLeftOutOfForecastTargets) {
  EXPECT_NEAR(transport::noise_target(5, {3, 0, 3}), 4, 1e-12);
  EXPECT_NEAR(transport::noise_target(5, {0, 0, 3 * transport::TargetErrorMargin}), 4, 1e-12);
  EXPECT_TRUE(transport::is_negligible({0, 0, 1}, 4));
  EXPECT_FALSE(transport::is_negligible({0, 0, 1}, 3.9));
  const auto scene = test::scene_of(lit_room());
  RenderSettings settings = settings_of(3, 64);
  settings.bias = {0.003, 0.003, 0.003};
  Render render(scene, settings);
  render.run();
  const auto forecasts = render.forecasts({0.05, 0.02, 0.01, 0.004});
  ASSERT_EQ(forecasts.size(), 2U);
  EXPECT_EQ(forecasts.back().target_error, 0.02);
}

}  // namespace
