#include "renderer/transport/film.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "renderer/image/image_error.h"
#include "renderer/transport/sobol.h"

namespace {

using image::Image;
using transport::Film;
using transport::FilmTile;
using transport::Rgb;

/// Adds a sample to each pixel of a tile; `radiance` gives its value for a position within the tile.
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

/// Two samples per pixel in each half, which are mostly dark and sometimes bright.
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

// Heavy tails: a few bright samples determine a pixel's variance. Of 200 intervals, 10 miss on average, and
// 20 or more with probability 1/500.
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

// A pixel that is bright in only one sample says as little of its own brightness as its neighbours do.
TEST(Film, IsNotMisledByARareBrightSample) {
  Film film(9, 9);
  add(film, 0, 0, Rgb(1));
  add_to_tile(film, 0, 1, [](int x, int y) { return Rgb(x == 4 && y == 4 ? 2001.0F : 1.0F); });
  EXPECT_NEAR(*film.estimated_error(), std::sqrt(1000.0 * 1000 / 1.01 / 81), 1);
}

// On black, where neighbours do not help: a lamp that covers half a pixel or less.
TEST(Film, DividesThePixelOfASmallLampByItself) {
  Film film(9, 9);
  for (int half = 0; half < Film::Scramblings; ++half) {
    add_to_tile(film, 0, half,
                [&](int x, int y) { return Rgb(x == 4 && y == 4 ? 9.0F + static_cast<float>(half) : 0.0F); });
  }
  // A deviation of 0.5 from 9.5.
  EXPECT_NEAR(*film.estimated_error(), 0.5 / 9.5 / 9, 0.01 * 0.5 / 9.5 / 9);
}

// The edge of a lamp: the coverage differs per pixel of a column, and the halves know it to 2 %. The pixels
// and samples are many, since few could not: then edges of unknown coverage are known to be worse.
TEST(Film, DividesThePixelsOfAnEdgeByThemselves) {
  constexpr int Side = Film::TileSize;
  constexpr int Tiles = 4;
  Film film(Side, Tiles * Side);
  for (int i = 0; i < 4000 * Tiles; ++i) {
    const float factor = i % 2 == 0 ? 0.98F : 1.02F;
    add_to_tile(film, i / 4000, i % 2, [&](int x, int y) {
      return Rgb(x < 8 ? 0.05F : x > 8 ? 600.0F : factor * static_cast<float>(y + 60));
    });
  }
  const double expected = 0.02 / std::sqrt(static_cast<double>(Side));
  EXPECT_NEAR(*film.estimated_error(), expected, 0.03 * expected);
}

// Dots that were hit once, half of which were not seen at all: this is estimated from those hit in both
// halves. Each of `Dots` pixels has radiance 1 in one sample of a half with probability 1/2, so the mean is
// 1/2 and its variance 1/8.
TEST(Film, KnowsFromAllLoneDotsHowOftenTheyAreHit) {
  constexpr int Side = 160;
  constexpr int Apart = 4;
  std::mt19937 random(3);
  std::bernoulli_distribution hit(0.5);
  Film film(Side, Side);
  for (int tile = 0; tile < film.tile_count(); ++tile) {
    for (int half = 0; half < Film::Scramblings; ++half) {
      add_to_tile(film, tile, half, [&](int x, int y) {
        return Rgb(x % Apart == 2 && y % Apart == 2 && hit(random) ? 100.0F : 0.0F);
      });
    }
  }
  const double expected = std::sqrt(0.5) / Apart;
  EXPECT_NEAR(*film.estimated_error(), expected, 0.3 * expected);
}

// The edges of lamps on black. Most of the error is in pixels with so little coverage that one of 16 samples
// has hit them, or none.
struct EdgeStudy {
  static constexpr int Films = 60;
  static constexpr int HalfSamples = 8;
  static constexpr int Side = 2 * Film::TileSize;
  int inside = 0;        ///< true errors within their interval
  double quotients = 0;  ///< mean of estimated over true error
};

struct PixelEdge {
  double coverage = 0;  ///< of the bright side
  std::array<int, Film::Scramblings> hits = {};

  /// A pixel that is covered, 1, or not, 0.
  static PixelEdge of(int coverage) {
    const int hits = coverage * EdgeStudy::HalfSamples;
    return {static_cast<double>(coverage), {hits, hits}};
  }
};

/// Estimates the errors of films whose pixels are partly covered by a bright object: `edge_at` returns, per
/// film and pixel, the covered part of a pixel, with the number of the samples of a half that hit it.
template <class EdgeAt>
EdgeStudy study_edges(const EdgeAt& edge_at) {
  EdgeStudy study;
  for (int i = 0; i < EdgeStudy::Films; ++i) {
    Image truth{EdgeStudy::Side, EdgeStudy::Side, {}};
    std::vector<PixelEdge> edges;
    for (int y = 0; y < EdgeStudy::Side; ++y) {
      for (int x = 0; x < EdgeStudy::Side; ++x) {
        edges.push_back(edge_at(x, y));
        truth.pixels.emplace_back(static_cast<float>(10 * edges.back().coverage));
      }
    }
    Film film(EdgeStudy::Side, EdgeStudy::Side);
    for (int tile = 0; tile < film.tile_count(); ++tile) {
      const transport::TileBounds bounds = film.bounds_of(tile);
      for (int half = 0; half < Film::Scramblings; ++half) {
        add_to_tile(film, tile, half, [&](int x, int y) {
          const int pixel = (bounds.y + y) * EdgeStudy::Side + bounds.x + x;
          const int hits = edges[static_cast<std::size_t>(pixel)].hits[static_cast<std::size_t>(half)];
          return Rgb(10 * static_cast<float>(hits) / EdgeStudy::HalfSamples);
        });
      }
    }
    const auto estimate = *film.error_estimate();
    const double error = std::sqrt(error_of(film.mean(), truth).relmse);
    study.inside += error >= estimate.low && error <= estimate.high ? 1 : 0;
    study.quotients += estimate.error / error / EdgeStudy::Films;
  }
  return study;
}

/// A straight edge through a pixel at any place and angle, and the samples of a render that hit the bright
/// side.
PixelEdge random_edge(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform;
  const double angle = 2 * std::numbers::pi * uniform(random);
  const double place = std::sqrt(0.5) * (2 * uniform(random) - 1);
  const auto is_covered = [&](double x, double y) {
    return (x - 0.5) * std::cos(angle) + (y - 0.5) * std::sin(angle) > place;
  };
  PixelEdge edge;
  constexpr int Cells = 100;
  for (int i = 0; i < Cells * Cells; ++i) {
    const bool covers = is_covered((i % Cells + 0.5) / Cells, (i / Cells + 0.5) / Cells);
    edge.coverage += covers ? 1.0 / (Cells * Cells) : 0;
  }
  for (int& hits : edge.hits) {
    const auto seed = static_cast<std::uint32_t>(random());
    for (std::uint32_t i = 0; i < EdgeStudy::HalfSamples; ++i) {
      const transport::Uniform4 at = transport::PathSampler(seed, i).next();
      hits += is_covered(double(at.x), double(at.y)) ? 1 : 0;
    }
  }
  return edge;
}

TEST(Film, StatesTheErrorOfEdgesThatFewSamplesHit) {
  std::mt19937 random(6);
  const EdgeStudy study = study_edges(
      [&](int x, int) { return x % 8 == 4 ? random_edge(random) : PixelEdge::of(x % 8 > 4 ? 1 : 0); });
  EXPECT_GE(study.inside, EdgeStudy::Films - 8);
  EXPECT_GT(study.quotients, 0.85);
  EXPECT_LT(study.quotients, 1.2);
}

// The bright side is in other tiles than the pixels that it equally covers in part: neither a pixel nor its
// tile knows what is beside it. Samples are perfectly stratified, so that a half has floor or ceil of the
// covered fraction of its samples.
TEST(Film, StatesTheErrorOfAnEdgeAtTheBorderOfTiles) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform;
  const EdgeStudy study = study_edges([&](int, int y) {
    if (y != 15) return PixelEdge::of(y < 15 ? 0 : 1);
    PixelEdge edge{0.1, {}};
    for (int& hits : edge.hits)
      hits = static_cast<int>(EdgeStudy::HalfSamples * edge.coverage + uniform(random));
    return edge;
  });
  EXPECT_GE(study.inside, EdgeStudy::Films - 8);
  EXPECT_GT(study.quotients, 0.8);
  EXPECT_LT(study.quotients, 1.3);
}

/// Normally distributed noise of one percent.
Film film_with_noise(std::mt19937& random, int width, int height) {
  std::normal_distribution<float> noise(1, 0.01F);
  Film film(width, height);
  for (int tile = 0; tile < film.tile_count(); ++tile) {
    for (int half = 0; half < Film::Scramblings; ++half) {
      add_to_tile(film, tile, half, [&](int, int) { return Rgb(noise(random)); });
    }
  }
  return film;
}

// The logarithm of the ratio of two chi-square variables of N degrees of freedom has a variance of about 4 /
// N; that of the error is half of it.
TEST(Film, StatesTheIntervalOfNormalNoise) {
  std::mt19937 random(4);
  const auto estimate = *film_with_noise(random, 64, 64).error_estimate();
  const double expected = std::exp(1.96 / 64);
  EXPECT_NEAR(std::log(estimate.high / estimate.error), std::log(expected), 0.25 * std::log(expected));
  EXPECT_NEAR(std::log(estimate.error / estimate.low), std::log(expected), 0.25 * std::log(expected));
}

// Of 400 intervals, 20 miss on average; fewer than 5 with probability 1/10,000, more than 34 with 1/1,000.
TEST(Film, StatesAnIntervalThatHoldsAndIsNotTooWide) {
  std::mt19937 random(5);
  constexpr int Films = 400;
  int missed = 0;
  for (int i = 0; i < Films; ++i) {
    const Film film = film_with_noise(random, 32, 16);
    double squares = 0;
    for (const Rgb& pixel : film.mean().pixels) squares += std::pow(pixel.x - 1.0, 2);
    const double error = std::sqrt(squares / (32 * 16) / 1.01);
    const auto estimate = *film.error_estimate();
    missed += error < estimate.low || error > estimate.high ? 1 : 0;
  }
  EXPECT_GE(missed, 5);
  EXPECT_LE(missed, 34);
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
