#include "renderer/transport/film.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace {

using transport::Film;
using transport::Image;
using transport::Rgb;

TEST(Film, KeepsMeanAndVarianceOfTwoHalves) {
  Film film(2, 1);
  film.add(0, 0, 0, Rgb(1, 2, 3));
  film.add(0, 0, 1, Rgb(3, 2, 1));
  EXPECT_EQ(film.mean().at(0, 0), Rgb(2, 2, 2));
  EXPECT_EQ(film.variance().at(0, 0), Rgb(1, 0, 1));
  EXPECT_EQ(film.mean().at(1, 0), Rgb(0));
  EXPECT_EQ(film.sample_count(0, 0), 2U);
}

TEST(Film, KnowsNoErrorFromOneHalf) {
  Film film(1, 1);
  film.add(0, 0, 0, Rgb(1));
  EXPECT_FALSE(film.estimated_error());
}

TEST(Film, EstimatesTheTrueError) {
  constexpr int Side = 100;
  constexpr int Samples = 20;
  std::mt19937 random(1);
  std::exponential_distribution<float> radiance(1);
  Film film(Side, Side);
  for (int y = 0; y < Side; ++y) {
    for (int x = 0; x < Side; ++x) {
      for (int i = 0; i < Samples; ++i) film.add(x, y, i % 2, Rgb(radiance(random), 1, 1));
    }
  }
  // The first channel has mean 1 and variance 1 / Samples, the others have no error.
  double expected = 0;
  const Image mean = film.mean();
  for (const Rgb& pixel : mean.pixels) expected += (pixel.x - 1) * (pixel.x - 1) / 1.01;
  expected = std::sqrt(expected / (3 * Side * Side));
  ASSERT_TRUE(film.estimated_error());
  EXPECT_NEAR(*film.estimated_error(), expected, 0.05 * expected);
}

TEST(Film, TakesNothingThatIsNotFinite) {
  Film film(1, 1);
  EXPECT_TRUE(film.add(0, 0, 0, Rgb(1)));
  EXPECT_FALSE(film.add(0, 0, 1, Rgb(std::numeric_limits<float>::quiet_NaN())));
  EXPECT_FALSE(film.add(0, 0, 1, Rgb(std::numeric_limits<float>::infinity())));
  EXPECT_TRUE(std::isfinite(film.mean().at(0, 0).x));
}

TEST(Film, LosesNothingOverAMillionSamples) {
  Film film(1, 1);
  for (int i = 0; i < 1'000'000; ++i) film.add(0, 0, i % 2, Rgb(0.1F));
  EXPECT_EQ(film.mean().at(0, 0), Rgb(0.1F));
}

}  // namespace
