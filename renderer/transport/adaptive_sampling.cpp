#include "renderer/transport/adaptive_sampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace transport {
namespace {

/// The spread of a tile's pixels, an eighth of which comes from the adjacent tiles: rare light paths there
/// are likely to reach this tile too.
double smooth_spread(const Film& film, int tile, std::size_t half) {
  const int across = film.tiles_across();
  const int x = tile % across;
  const int y = tile / across;
  double sum = 0;
  double pixels = 0;
  for (int k = std::max(y - 1, 0); k <= std::min(y + 1, film.tiles_down() - 1); ++k) {
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, across - 1); ++i) {
      if (film.sample_count_of(k * across + i) == 0) continue;
      sum += film.spreads_of(k * across + i)[half];
      pixels += static_cast<double>(film.bounds_of(k * across + i).pixel_count());
    }
  }
  const double own = film.spreads_of(tile)[half] / static_cast<double>(film.bounds_of(tile).pixel_count());
  return (7 * own + sum / pixels) / 8;
}

/// Scales the weights, but to no less than `least`, so that their mean over the pixels is `mean`.
std::vector<double> in_proportion(const std::vector<double>& weights, const std::vector<double>& pixels,
                                  double mean, double least) {
  const auto numbers_with = [&](double scale) {
    std::vector<double> numbers;
    for (const double weight : weights) numbers.push_back(std::max(least, scale * weight));
    return numbers;
  };
  const auto sum_over_pixels = [&](const std::vector<double>& numbers) {
    return std::inner_product(numbers.begin(), numbers.end(), pixels.begin(), 0.0);
  };
  const double pixel_count = std::accumulate(pixels.begin(), pixels.end(), 0.0);
  const double mean_weight = sum_over_pixels(weights) / pixel_count;
  if (!(mean_weight > 0) || !std::isfinite(mean_weight)) return std::vector<double>(weights.size(), mean);
  double low = 0;
  double high = mean / mean_weight;  // with which the sum is large enough
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (sum_over_pixels(numbers_with(middle)) > mean * pixel_count ? high : low) = middle;
  }
  return numbers_with(low);
}

}  // namespace

FilmTile::Counts uniform_counts(int samples) {
  const auto count = static_cast<std::uint32_t>(samples);
  static_assert(Film::Scramblings == 2);
  return {count - count / 2, count / 2};
}

AdaptiveSampling::AdaptiveSampling(const Film& film) {
  for (int tile = 0; tile < film.tile_count(); ++tile) {
    const bool has_samples = film.sample_count_of(tile) > 0;
    pixels_.push_back(has_samples ? static_cast<double>(film.bounds_of(tile).pixel_count()) : 0);
    for (std::size_t half = 0; half < weights_.size(); ++half) {
      weights_[half].push_back(has_samples ? std::sqrt(smooth_spread(film, tile, 1 - half)) : 0);
    }
  }
}

std::vector<FilmTile::Counts> AdaptiveSampling::counts(int samples) const {
  constexpr double Most = 1U << 30U;
  const double mean = samples / 2.0;
  const double least = std::max(PilotSamples / 2.0, MinFraction * mean);
  std::vector<FilmTile::Counts> counts(pixels_.size());
  for (std::size_t half = 0; half < weights_.size(); ++half) {
    const std::vector<double> wanted = in_proportion(weights_[half], pixels_, mean, least);
    for (std::size_t tile = 0; tile < counts.size(); ++tile) {
      if (pixels_[tile] == 0) continue;
      // Even numbers, so that unequal counts differ by more than one sample; see FilmTile::mean.
      counts[tile][half] = static_cast<std::uint32_t>(std::min(Most, wanted[tile])) / 2 * 2;
    }
  }
  return counts;
}

}  // namespace transport
