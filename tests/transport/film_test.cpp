#include "renderer/transport/film.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace {

using transport::Film;
using transport::FilmTile;
using transport::Image;
using transport::Rgb;

/// Adds a sample to each pixel of a tile; `radiance` gives it for a place within the tile.
template <class Function>
void add_to_tile(Film& film, int tile, int scrambling, Function radiance) {
  FilmTile sums;
  film.copy_tile(tile, sums);
  for (int y = 0; y < sums.bounds.height; ++y) {
    for (int x = 0; x < sums.bounds.width; ++x) sums.add(x, y, scrambling, radiance(x, y));
  }
  ++sums.counts[static_cast<std::size_t>(scrambling)];
  film.put_back(tile, sums);
}

void add(Film& film, int tile, int scrambling, const Rgb& radiance) {
  add_to_tile(film, tile, scrambling, [&](int, int) { return radiance; });
}

TEST(Film, KeepsMeanAndVarianceOfTwoHalves) {
  Film film(Film::TileSize + 1, 1);
  add(film, 0, 0, Rgb(1, 2, 3));
  add(film, 0, 1, Rgb(3, 2, 1));
  EXPECT_EQ(film.mean().at(0, 0), Rgb(2, 2, 2));
  EXPECT_EQ(film.variance().at(0, 0), Rgb(1, 0, 1));
  EXPECT_EQ(film.mean().at(Film::TileSize, 0), Rgb(0));
  EXPECT_EQ(film.sample_count(0, 0), 2U);
  EXPECT_EQ(film.sample_count(Film::TileSize, 0), 0U);
}

// Two samples against one: the variance of the mean of three is 2/9 of the squared difference.
TEST(Film, WeighsHalvesOfDifferentSize) {
  Film film(1, 1);
  for (const int scrambling : {0, 1, 0}) add(film, 0, scrambling, Rgb(scrambling == 0 ? 1.0F : 4.0F));
  EXPECT_EQ(film.mean().at(0, 0), Rgb(2));
  EXPECT_EQ(film.variance().at(0, 0), Rgb(2));
}

TEST(Film, KnowsNoErrorFromOneHalf) {
  Film film(1, 1);
  add(film, 0, 0, Rgb(1));
  EXPECT_FALSE(film.estimated_error());
}

// Sizes that are no multiple of a tile's.
TEST(Film, EveryPixelHasItsPlace) {
  Film film(2 * Film::TileSize + 3, Film::TileSize + 5);
  std::size_t pixels = 0;
  for (int tile = 0; tile < film.tile_count(); ++tile) {
    const transport::TileBounds bounds = film.bounds_of(tile);
    pixels += bounds.pixel_count();
    add_to_tile(film, tile, 0, [&](int x, int y) {
      return Rgb(static_cast<float>(bounds.x + x), static_cast<float>(bounds.y + y), 1);
    });
  }
  const Image image = film.mean();
  EXPECT_EQ(pixels, image.pixels.size());
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      ASSERT_EQ(image.at(x, y), Rgb(static_cast<float>(x), static_cast<float>(y), 1));
    }
  }
}

TEST(Film, EstimatesTheTrueError) {
  constexpr int Side = 100;
  constexpr int Samples = 20;
  std::mt19937 random(1);
  std::exponential_distribution<float> radiance(1);
  Film film(Side, Side);
  for (int tile = 0; tile < film.tile_count(); ++tile) {
    for (int i = 0; i < Samples; ++i) {
      add_to_tile(film, tile, i % 2, [&](int, int) { return Rgb(radiance(random), 1, 1); });
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

/// Two samples of a pixel in each half, that are mostly dark and sometimes bright.
template <class Random>
Film rarely_bright_film(Random& random) {
  std::bernoulli_distribution bright(0.1);
  Film film(48, 32);
  for (int tile = 0; tile < film.tile_count(); ++tile) {
    for (int i = 0; i < 32; ++i) {
      add_to_tile(film, tile, i % 2, [&](int, int) { return Rgb(bright(random) ? 5.0F : 0.5F); });
    }
  }
  return film;
}

// Heavy tails: the variance of a pixel follows from a few bright samples. Of 200 intervals, 10 miss in the
// mean, and 20 or more in one case of 500.
TEST(Film, StatesAnIntervalThatHolds) {
  std::mt19937 random(2);
  constexpr int Films = 200;
  constexpr double Truth = 0.1 * 5 + 0.9 * 0.5;
  int inside = 0;
  for (int i = 0; i < Films; ++i) {
    const Film film = rarely_bright_film(random);
    double squares = 0;
    for (const Rgb& pixel : film.mean().pixels) squares += (pixel.x - Truth) * (pixel.x - Truth);
    const double error = std::sqrt(squares / (48 * 32) / (Truth * Truth + 0.01));
    const auto estimate = *film.error_estimate();
    EXPECT_LT(estimate.low, estimate.error);
    EXPECT_GT(estimate.high, estimate.error);
    inside += error >= estimate.low && error <= estimate.high ? 1 : 0;
  }
  EXPECT_GT(inside, Films - 20);
}

// A pixel that is bright in one sample alone says as little of its own brightness as its neighbours do.
TEST(Film, IsNotMisledByARareBrightSample) {
  Film film(9, 9);
  add(film, 0, 0, Rgb(1));
  add_to_tile(film, 0, 1, [](int x, int y) { return Rgb(x == 4 && y == 4 ? 2001.0F : 1.0F); });
  EXPECT_NEAR(*film.estimated_error(), std::sqrt(1000.0 * 1000 / 1.01 / 81), 1);
}

TEST(Film, WeighsHalvesThatWerePlacedAlike) {
  Film film(1, 1);
  for (const int scrambling : {0, 0, 0, 1}) add(film, 0, scrambling, Rgb(scrambling == 0 ? 1.0F : 4.0F));
  EXPECT_EQ(film.mean().at(0, 0), Rgb(2.5F));
  EXPECT_EQ(film.variance().at(0, 0), Rgb(2.25F));
}

TEST(Film, LeavesOutWhatIsNotFinite) {
  Film film(1, 1);
  FilmTile tile;
  film.copy_tile(0, tile);
  EXPECT_TRUE(tile.add(0, 0, 0, Rgb(1)));
  EXPECT_FALSE(tile.add(0, 0, 1, Rgb(std::numeric_limits<float>::quiet_NaN())));
  EXPECT_FALSE(tile.add(0, 0, 1, Rgb(std::numeric_limits<float>::infinity())));
  tile.counts = {1, 2};
  film.put_back(0, tile);
  EXPECT_EQ(film.mean().at(0, 0), Rgb(1 / 3.0F));
}

TEST(Film, LosesNothingOverAMillionSamples) {
  Film film(1, 1);
  for (int i = 0; i < 1'000'000; ++i) add(film, 0, i % 2, Rgb(0.1F));
  EXPECT_EQ(film.mean().at(0, 0), Rgb(0.1F));
}

}  // namespace
