// The shares of noise are compared with those that images of other scenes give, rendered with the same random
// numbers.
#include "renderer/transport/noise.h"

#include <array>
#include <cmath>
#include <map>

#include <gmock/gmock.h>

#include "tests/transport/scene_helpers.h"

namespace {

using grf::Vec3d;
using transport::NoiseShare;
using transport::NoiseShares;
using transport::Rgb;

constexpr int Images = 3000;
constexpr int Size = 3;

/// A floor beside a wall, under two lamps of these radiances.
std::string corner(const std::string& left, const std::string& right) {
  return "light begin rgb " + left + " (-2,-0.5,1) (0,1,0) (1,0,0) end " +  //
         "light begin rgb " + right + " (0.2,-0.5,2) (0,1,0) (1,0,0) end " +
         test::quad("brdf diffuse kd=0.7", "(-3,-3,0) (3,-3,0) (3,3,0) (-3,3,0)") +
         test::quad("brdf phong n=5 ks=0.5 kd=0.4", "(-3,1,0) (3,1,0) (3,1,3) (-3,1,3)");
}

test::RenderSetup setup_of(int depth) {
  test::RenderSetup setup;
  setup.eye = grf::Vec3f(0, -2, 2);
  setup.field_of_view = 5;
  setup.width = setup.height = Size;
  setup.samples = 2;
  setup.depth = depth;
  setup.split_count = 1;
  setup.threads = 1;
  return setup;
}

/// The pixels of independent images of a scene.
std::vector<std::vector<Rgb>> images_of(const transport::CompiledScene& scene, test::RenderSetup setup) {
  std::vector<std::vector<Rgb>> images;
  for (setup.seed = 0; setup.seed < Images; ++setup.seed)
    images.push_back(render(scene, setup).mean().pixels);
  return images;
}

/// The share of a part of each image in the variance of all of it, of the first channel: the part is that of
/// a channel of other images, times a factor.
double share_of(const std::vector<std::vector<Rgb>>& parts, int channel, double factor,
                const std::vector<std::vector<Rgb>>& wholes) {
  double covariance = 0;
  double variance = 0;
  for (std::size_t pixel = 0; pixel < Size * Size; ++pixel) {
    double part = 0;
    double whole = 0;
    for (std::size_t i = 0; i < Images; ++i) {
      part += factor * double(parts[i][pixel][channel]) / Images;
      whole += double(wholes[i][pixel].x) / Images;
    }
    const double weight = 1 / (whole * whole + 0.01);
    for (std::size_t i = 0; i < Images; ++i) {
      const double off = double(wholes[i][pixel].x) - whole;
      covariance += weight * off * (factor * double(parts[i][pixel][channel]) - part);
      variance += weight * off * off;
    }
  }
  return covariance / variance;
}

NoiseShares shares_of(const transport::CompiledScene& scene, const test::RenderSetup& setup) {
  const std::atomic<bool> stopped = false;
  const auto shares = noise_shares(scene, settings_of(setup), {Images, 1}, stopped);
  EXPECT_TRUE(shares);
  return shares.value_or(NoiseShares());
}

std::map<std::uint32_t, double> by_index(const std::vector<NoiseShare>& shares) {
  std::map<std::uint32_t, double> noise;
  for (const NoiseShare& share : shares) noise[share.index] = share.noise;
  return noise;
}

double sum_of(const std::vector<NoiseShare>& shares, double NoiseShare::*value) {
  double sum = 0;
  for (const NoiseShare& share : shares) sum += share.*value;
  return sum;
}

TEST(NoiseShares, OfLampsAreThoseOfImagesWithColouredLamps) {
  const auto grey = test::scene_of(corner("(1,1,1)", "(4,4,4)"));
  // The lamps have the same powers, and so are chosen by the same random numbers.
  const auto coloured = test::scene_of(corner("(3,0,0)", "(0,12,0)"));
  const auto wholes = images_of(grey, setup_of(2));
  const auto parts = images_of(coloured, setup_of(2));
  const NoiseShares shares = shares_of(grey, setup_of(2));
  auto noise = by_index(shares.lamps);
  ASSERT_EQ(noise.size(), 2U);
  const double left = share_of(parts, 0, 1.0 / 3, wholes);
  const double right = share_of(parts, 1, 1.0 / 3, wholes);
  EXPECT_NEAR(left + right, 1, 1e-4);
  EXPECT_GT(std::abs(left - right), 0.1) << "else an exchange of the lamps is not seen";
  EXPECT_NEAR(noise[0], left, 0.05);
  EXPECT_NEAR(noise[1], right, 0.05);
}

TEST(NoiseShares, OfBouncesAreThoseOfImagesOfFewerBounces) {
  const auto scene = test::scene_of(corner("(1,1,1)", "(4,4,4)"));
  const auto wholes = images_of(scene, setup_of(2));
  const auto direct = images_of(scene, setup_of(1));
  const NoiseShares shares = shares_of(scene, setup_of(2));
  auto noise = by_index(shares.bounces);
  const double expected = share_of(direct, 0, 1, wholes);
  EXPECT_GT(expected, 0.1);
  EXPECT_LT(expected, 0.9);
  EXPECT_NEAR(noise[1], expected, 0.05);
  EXPECT_NEAR(noise[2], 1 - expected, 0.05);
  // Light of two bounces was first reflected by the wall.
  auto reflectors = by_index(shares.reflectors);
  const auto& tables = scene.tables();
  for (std::uint32_t i = 0; i < tables.size(); ++i) {
    const bool is_floor = tables[i].brdf.find("diffuse") != std::string::npos;
    EXPECT_NEAR(reflectors[i], is_floor ? noise[1] : noise[2], 1e-6) << tables[i].brdf;
  }
}

TEST(NoiseShares, AreWhole) {
  const auto scene = test::scene_of(corner("(1,1,1)", "(4,4,4)"));
  test::RenderSetup setup = setup_of(5);
  setup.split_count = 3;
  setup.background = 0.5F;
  setup.field_of_view = 60;
  setup.width = setup.height = 12;
  const std::atomic<bool> stopped = false;
  const auto shares = noise_shares(scene, settings_of(setup), {4, 8}, stopped);
  ASSERT_TRUE(shares);
  EXPECT_GT(shares->error, 0);
  for (const auto& list : {shares->lamps, shares->bounces, shares->reflectors}) {
    EXPECT_NEAR(sum_of(list, &NoiseShare::noise), 1, 1e-9);
    EXPECT_NEAR(sum_of(list, &NoiseShare::light), 1, 1e-9);
    EXPECT_TRUE(std::is_sorted(list.begin(), list.end(),
                               [](const NoiseShare& a, const NoiseShare& b) { return a.noise > b.noise; }));
  }
  EXPECT_EQ(shares->lamps.size(), 3U) << "two lamps and the background";
}

TEST(NoiseShares, HaveTheErrorOfAnImage) {
  const auto scene = test::scene_of(corner("(1,1,1)", "(4,4,4)"));
  test::RenderSetup setup = setup_of(3);
  setup.field_of_view = 40;
  setup.width = setup.height = 24;
  setup.samples = 1000;
  const image::Image truth = render(scene, setup).mean();
  setup.samples = 16;
  setup.seed = 7;
  const image::Image image = render(scene, setup).mean();
  double squares = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      const double exact = truth.pixels[i][channel];
      const double off = double(image.pixels[i][channel]) - exact;
      squares += off * off / (exact * exact + 0.01) / (3.0 * double(image.pixels.size()));
    }
  }
  const std::atomic<bool> stopped = false;
  const auto shares = noise_shares(scene, settings_of(setup), {8, 16}, stopped);
  ASSERT_TRUE(shares);
  EXPECT_NEAR(shares->error / std::sqrt(squares), 1, 0.2);
}

TEST(NoiseShares, AreNoneOfALightThatTheEyeSeesAlone) {
  const auto scene = test::scene_of(test::quad("brdf diffuse kd=0.5", "(-3,-3,9) (3,-3,9) (3,3,9) (-3,3,9)"));
  test::RenderSetup setup = setup_of(2);
  setup.background = 1;
  setup.target = grf::Vec3f(0, -5, -5);
  const std::atomic<bool> stopped = false;
  EXPECT_FALSE(noise_shares(scene, settings_of(setup), {4, 4}, stopped)) << "a constant has no noise";
  const std::atomic<bool> is_stopped = true;
  EXPECT_FALSE(noise_shares(scene, settings_of(setup), {4, 4}, is_stopped));
}

}  // namespace
