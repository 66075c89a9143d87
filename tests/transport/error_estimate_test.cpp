// A short version, with a few seeds, of error_statistics_test.
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/transport/bright_scenes.h"
#include "tests/transport/error_study.h"

namespace {

transport::PixelMoments black_pixels(int width, int height, double samples) {
  const std::vector<Imath::V3d> black(static_cast<std::size_t>(width * height), Imath::V3d(0));
  return {{0, 0, width, height}, samples, black, black};
}

TEST(ErrorSums, AddUpAllThatPartsSay) {
  using Numbers = std::array<double, sizeof(transport::ErrorSums) / sizeof(double)>;
  Numbers a;
  Numbers b;
  Numbers both;
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] = static_cast<double>(1 + i);
    b[i] = static_cast<double>(100 + 7 * i);
    both[i] = a[i] + b[i];
  }
  auto sums = std::bit_cast<transport::ErrorSums>(a);
  sums += std::bit_cast<transport::ErrorSums>(b);
  EXPECT_EQ(std::bit_cast<Numbers>(sums), both);
  EXPECT_EQ(std::bit_cast<Numbers>(sums - std::bit_cast<transport::ErrorSums>(a)), b);
}

// Of 96 intervals, 5 miss on average, and 12 or more do with probability 1/300.
TEST(ErrorEstimate, HoldsOnFourScenes) {
  test::ErrorStudy study;
  for (const test::SampleScene& scene : test::error_scenes()) test::study_errors(scene, 24, 32, study);
  EXPECT_GE(study.inside, study.runs - 12);
  EXPECT_GT(study.stated_over_true(), 0.87);
  EXPECT_LT(study.stated_over_true(), 1.3);
  EXPECT_LE(study.missed, 12);
}

struct BrightCase {
  test::ErrorCase tested;
  double width = 0;  ///< the largest mean ratio of the upper to the lower bound
};

// Dividing a pixel's error by its darker neighbours would overstate it two to ten times. Of 20 intervals 5 or
// more miss with probability 1/400; the seeds are fixed.
TEST(ErrorEstimate, HoldsWithLampsInView) {
  using test::BrightScene;
  const std::string diffuse = "brdf diffuse kd=0.6";
  const BrightCase cases[] = {
      {test::cornell_case(32, 12), 9},
      {test::cornell_case(48, 64), 3},
      {BrightScene(48).strips(5, 0.4, 0.05, 20).with("strips", 16), 10},
      {BrightScene(48).lamps(3, 16.3, 16, 3.5, 0, 8).with("corners at tile borders", 32), 6},
      {BrightScene(48).lamps(6, 6, 7, 0.8, 0.3, 20).with("dots", 64), 6},
      {BrightScene(32).wall(diffuse).with("a wall", 16), 1.5},
  };
  for (const BrightCase& bright : cases) {
    SCOPED_TRACE(bright.tested.scene.name);
    test::ErrorStudy study;
    test::study_intervals(bright.tested.scene, 20, bright.tested.samples, study);
    EXPECT_GE(study.inside, study.runs - 4);
    EXPECT_GT(study.mean_quotient(), 0.8);
    EXPECT_LT(study.mean_quotient(), 1.4);
    EXPECT_LT(study.mean_width(), bright.width);
  }
}

// Half of the samples hit each of three pixels. Divided by their dark neighbours, their error would be stated
// as four times as large.
TEST(ErrorEstimate, DoesNotTakeASmallLampForNoise) {
  transport::PixelMoments pixels = black_pixels(24, 24, 4);
  const auto set = [&](int x, int y, double mean, double deviation) {
    pixels.means[pixels.index_of(x, y)] = Imath::V3d(mean);
    pixels.variances[pixels.index_of(x, y)] = Imath::V3d(deviation * deviation);
  };
  for (const auto& [x, y] : {std::pair(11, 11), std::pair(12, 11), std::pair(11, 12)}) set(x, y, 10, 10);
  const auto as_a_lamp = transport::error_estimate_of(transport::error_sums_of(pixels, pixels.bounds));
  EXPECT_LE(as_a_lamp->error, std::sqrt(3 * 1.0 / 576) * 1.05);
  EXPECT_GT(as_a_lamp->error, std::sqrt(0.1 / 576));
  // The same pixels among others that are as bright by chance are noise.
  for (int y = 1; y < 24; y += 4) {
    for (int x = 1; x < 24; x += 4) set(x, y, 10, 10);
  }
  const auto as_noise = transport::error_sums_of(pixels, pixels.bounds);
  EXPECT_GT(as_noise.errors, 20);
}

// A bright half plane covers hundredths of a row of dark pixels, and of 15 pixels one was hit in both halves.
// The halves agree, and the error is 2 hits of 9/16 less the mean: (1.125 - 0.075)^2 15/14 / (1.075^2 +
// 0.01).
TEST(ErrorSums, SeeWhereBothHalvesWereHitByChance) {
  transport::PixelMoments pixels = black_pixels(15, 16, 16);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 15; ++x) pixels.means[pixels.index_of(x, y)] = Imath::V3d(y < 8 ? 1 : 10);
  }
  pixels.means[pixels.index_of(7, 7)] = Imath::V3d(1 + 2 * 9.0 / 16);
  const auto sums = transport::error_sums_of(pixels, {7, 7, 1, 1});
  EXPECT_NEAR(sums.errors, 3 * 1.05 * 1.05 * 15 / 14 / (1.075 * 1.075 + 0.01), 1e-9);
}

// The lamps are thinner than a pixel, along a row and along a column. With all eight neighbours as the prior
// of each pixel, 1.2 times the error was stated.
TEST(ErrorEstimate, TakesPixelsOfAThinLineForAlike) {
  const auto wall = [] { return test::BrightScene(48).wall("brdf diffuse kd=0.6"); };
  for (const test::ErrorCase& tested : {wall().lamp(24, 24.4, 36, 0.12, 0, 20).with("a row", 32),
                                        wall().lamp(24.4, 24, 0.12, 36, 0, 20).with("a column", 32)}) {
    SCOPED_TRACE(tested.scene.name);
    test::ErrorStudy study;
    test::study_intervals(tested.scene, 20, tested.samples, study);
    EXPECT_GE(study.inside, study.runs - 4);
    EXPECT_GT(study.mean_quotient(), 0.9);
    EXPECT_LT(study.mean_quotient(), 1.15);
  }
}

// With probability 1/1,000, one of 72 blocks is off by 4.4 standard deviations.
TEST(AdaptiveSampling, HasTheMeanOfUniformSampling) {
  EXPECT_LT(test::largest_difference(test::sun_scene(), 64, 60), 4.4);
}

TEST(AdaptiveSampling, PaysWhereTheNoiseIsUneven) {
  test::SampleScene scene = test::sun_scene();
  scene.settings.width = 192;
  scene.settings.height = 128;
  scene.settings.samples = 256;
  double squared_errors[2] = {};
  for (const bool adaptive : {false, true}) {
    scene.settings.adaptive = adaptive;
    transport::Render render(scene.scene, scene.settings);
    render.run();
    EXPECT_NEAR(render.samples_per_pixel(), 256, 4);
    const double error = *render.film().estimated_error();
    squared_errors[adaptive ? 1 : 0] = error * error;
  }
  RecordProperty("gain", std::to_string(squared_errors[0] / squared_errors[1]));
  EXPECT_GT(squared_errors[0], 1.2 * squared_errors[1]);
}

}  // namespace
