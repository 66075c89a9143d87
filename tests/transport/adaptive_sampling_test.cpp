// Adaptive sampling with random numbers instead of light: unbiased, but biased if a half influenced its own
// sample counts.
#include "renderer/transport/adaptive_sampling.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace {

using transport::AdaptiveSampling;
using transport::Film;
using transport::FilmTile;
using transport::Rgb;

constexpr int Pilot = AdaptiveSampling::PilotSamples;

/// Adds samples to a tile up to these counts.
template <class Draw>
void fill(Film& film, int tile, const FilmTile::Counts& counts, Draw draw) {
  FilmTile sums;
  film.copy_tile(tile, sums);
  const FilmTile before = sums;
  for (int half = 0; half < Film::Scramblings; ++half) {
    for (std::uint32_t i = sums.counts[half]; i < counts[half]; ++i) {
      for (int p = 0; p < static_cast<int>(sums.bounds.pixel_count()); ++p) {
        sums.add(p % sums.bounds.width, p / sums.bounds.width, half, Rgb(draw(tile)));
      }
    }
  }
  sums.counts = counts;
  if (before.sample_count() == Pilot / 2) {
    for (int half = 0; half < Film::Scramblings; ++half) sums.spreads[half] = sums.spread_since(before, half);
  }
  film.put_back(tile, sums);
}

template <class Draw>
void fill_pilot(Film& film, Draw draw) {
  for (const int samples : {Pilot / 2, Pilot}) {
    for (int tile = 0; tile < film.tile_count(); ++tile) {
      fill(film, tile, transport::uniform_counts(samples), draw);
    }
  }
}

struct Mean {
  double value = 0;
  double deviation = 0;
};

enum class Placing { ByTheOtherHalf, ByItsOwn };

/// The mean of a pixel over many adaptive images, with samples that are mostly dark and sometimes bright. The
/// pixel is a tile of its own, so that its noise matters; another tile of 16 pixels competes with it.
Mean mean_of_images(Placing placing, int images) {
  std::mt19937 random(7);
  std::bernoulli_distribution bright(0.05);
  const auto draw = [&](int) { return bright(random) ? 20.0F : 0.0F; };
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < images; ++i) {
    Film film(Film::TileSize + 1, 1);
    fill_pilot(film, draw);
    for (int tile = 0; tile < film.tile_count() && placing == Placing::ByItsOwn; ++tile) {
      FilmTile sums;
      film.copy_tile(tile, sums);
      std::swap(sums.spreads[0], sums.spreads[1]);
      film.put_back(tile, sums);
    }
    const auto counts = AdaptiveSampling(film).counts(3 * Pilot);
    fill(film, 1, counts[1], draw);
    const double value = film.mean().at(Film::TileSize, 0).x;
    sum += value;
    squares += value * value;
  }
  const double mean = sum / images;
  return {mean, std::sqrt((squares / images - mean * mean) / images)};
}

// The samples' mean is 1. At 4 standard deviations, 1 of 16,000 correct programs would fail.
TEST(AdaptiveSampling, IsUnbiased) {
  const Mean mean = mean_of_images(Placing::ByTheOtherHalf, 40'000);
  EXPECT_LT(mean.deviation, 0.01);
  EXPECT_NEAR(mean.value, 1, 4 * mean.deviation);
}

TEST(AdaptiveSampling, WouldBeBiasedIfAHalfDecidedItsOwnCounts) {
  const Mean mean = mean_of_images(Placing::ByItsOwn, 40'000);
  EXPECT_LT(mean.value, 1 - 8 * mean.deviation);
}

TEST(AdaptiveSampling, PutsSamplesWhereTheNoiseIs) {
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  const float deviations[] = {0.1F, 0.1F, 0.4F, 0.1F, 0};
  const auto draw = [&](int tile) { return 1 + deviations[tile] * normal(random); };
  Film film(5 * Film::TileSize, Film::TileSize);
  fill_pilot(film, draw);
  const AdaptiveSampling placement(film);
  double before = 0;
  for (const int samples : {Pilot, 100, 1000, 100'000}) {
    const auto counts = placement.counts(samples);
    double mean = 0;
    for (const auto& count : counts) {
      mean += (count[0] + count[1]) / 5.0;
      EXPECT_GE(count[0] + count[1], static_cast<std::uint32_t>(std::max(Pilot, samples / 4 - 4)));
      EXPECT_EQ(count[0] % 2 + count[1] % 2, 0U);
    }
    EXPECT_LE(mean, samples);
    EXPECT_GE(mean, samples - 4);
    EXPECT_GT(mean, before);
    before = mean;
  }
  const auto counts = placement.counts(100'000);
  EXPECT_GT(counts[2][0], 2 * counts[0][0]);
  EXPECT_GT(counts[2][1], 2 * counts[0][1]);
  EXPECT_GT(counts[0][0], counts[4][0]);
}

TEST(AdaptiveSampling, IsUniformWithoutNoise) {
  Film film(3 * Film::TileSize, Film::TileSize);
  fill_pilot(film, [](int) { return 0.5F; });
  for (const auto& count : AdaptiveSampling(film).counts(100)) {
    EXPECT_EQ(count, (FilmTile::Counts{50, 50}));
  }
}

TEST(AdaptiveSampling, NeverTakesSamplesAway) {
  std::mt19937 random(5);
  std::exponential_distribution<float> draw(1);
  Film film(4 * Film::TileSize, 3 * Film::TileSize);
  fill_pilot(film, [&](int tile) { return static_cast<float>(tile) * draw(random); });
  const AdaptiveSampling placement(film);
  auto before = placement.counts(Pilot);
  for (int samples = Pilot + 1; samples < 500; ++samples) {
    const auto counts = placement.counts(samples);
    for (std::size_t tile = 0; tile < counts.size(); ++tile) {
      ASSERT_GE(counts[tile][0], before[tile][0]) << samples;
      ASSERT_GE(counts[tile][1], before[tile][1]) << samples;
    }
    before = counts;
  }
}

}  // namespace
