#include "renderer/transport/film.h"

#include <algorithm>
#include <cmath>

namespace transport {

bool FilmTile::add(int x, int y, int scrambling, const Rgb& radiance) {
  const bool finite = std::isfinite(radiance.x) && std::isfinite(radiance.y) && std::isfinite(radiance.z);
  if (!finite) return false;
  PixelSums& sums = pixels[bounds.index_of(x, y)];
  sums[static_cast<std::size_t>(scrambling)] += Imath::V3d(radiance);
  return true;
}

Rgb FilmTile::mean(std::size_t pixel) const { return Rgb(exact_mean(pixels[pixel])); }

Rgb FilmTile::variance(std::size_t pixel) const { return Rgb(exact_variance(pixels[pixel])); }

/// Whether all samples weigh the same.
bool FilmTile::is_even() const {
  return std::max(counts[0], counts[1]) - std::min(counts[0], counts[1]) <= 1 || counts[0] == 0 ||
         counts[1] == 0;
}

Imath::V3d FilmTile::exact_mean(const PixelSums& sums) const {
  const std::uint32_t count = sample_count();
  if (count == 0) return Imath::V3d(0);
  return is_even() ? (sums[0] + sums[1]) / count : (sums[0] / counts[0] + sums[1] / counts[1]) / 2;
}

// The halves are independent estimates of the same value. With weights p and 1 - p, the variance of their
// mean is p (1 - p) of the mean squared difference: a quarter, if they weigh the same.
Imath::V3d FilmTile::exact_variance(const PixelSums& sums) const {
  const double n = counts[0];
  const double m = counts[1];
  if (n == 0 || m == 0) return Imath::V3d(0);
  const Imath::V3d difference = sums[0] / n - sums[1] / m;
  const double weight = is_even() ? n / (n + m) : 0.5;
  return difference * difference * (weight * (1 - weight));
}

ErrorSums FilmTile::error_sums() const {
  if (counts[0] == 0 || counts[1] == 0) return {};
  PixelMoments moments{bounds.width, bounds.height, static_cast<double>(sample_count()), {}, {}};
  for (const PixelSums& sums : pixels) {
    moments.means.push_back(exact_mean(sums));
    moments.variances.push_back(exact_variance(sums));
  }
  return error_sums_of(moments);
}

// Of n and m samples, the difference of the two means has 1/n + 1/m of the variance of one.
double FilmTile::spread_since(const FilmTile& before, int scrambling) const {
  const auto half = static_cast<std::size_t>(scrambling);
  const double n = before.counts[half];
  const double m = counts[half] - n;
  double sum = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Imath::V3d& early = before.pixels[i][half];
    const Imath::V3d& all = pixels[i][half];
    const Imath::V3d difference = early / n - (all - early) / m;
    const Imath::V3d mean = all / (n + m);
    for (int k = 0; k < 3; ++k) sum += difference[k] * difference[k] / (mean[k] * mean[k] + 0.01);
  }
  return sum / (1 / n + 1 / m);
}

Film::Film(int width, int height) : width_(width), height_(height) {
  tiles_.resize(static_cast<std::size_t>(tiles_across()) * static_cast<std::size_t>(tiles_down()));
  pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

TileBounds Film::bounds_of(int tile) const {
  const int x = tile % tiles_across() * TileSize;
  const int y = tile / tiles_across() * TileSize;
  return {x, y, std::min(TileSize, width_ - x), std::min(TileSize, height_ - y)};
}

// Above the tile are whole rows; left of it are tiles of its own height.
std::size_t Film::first_pixel(const TileBounds& bounds) const {
  return static_cast<std::size_t>(bounds.y) * static_cast<std::size_t>(width_) +
         static_cast<std::size_t>(bounds.x) * static_cast<std::size_t>(bounds.height);
}

void Film::copy_tile(int tile, FilmTile& copy) const {
  copy.bounds = bounds_of(tile);
  copy.counts = counts_of(tile);
  copy.spreads = spreads_of(tile);
  const auto first = pixels_.begin() + static_cast<std::ptrdiff_t>(first_pixel(copy.bounds));
  copy.pixels.assign(first, first + static_cast<std::ptrdiff_t>(copy.bounds.pixel_count()));
}

void Film::put_back(int tile, const FilmTile& copy, const ErrorSums& error_sums) {
  tiles_[index(tile)] = {copy.counts, copy.spreads, error_sums};
  std::copy(copy.pixels.begin(), copy.pixels.end(),
            pixels_.begin() + static_cast<std::ptrdiff_t>(first_pixel(copy.bounds)));
}

std::uint32_t Film::sample_count(int x, int y) const { return sample_count_of(tile_of(x, y)); }

template <class Function>
Image Film::image_of(Function function) const {
  Image image{width_, height_, std::vector<Rgb>(pixels_.size())};
  FilmTile copy;
  for (int tile = 0; tile < tile_count(); ++tile) {
    copy_tile(tile, copy);
    write_tile(
        copy.bounds, [&](std::size_t i) { return function(copy, i); }, image);
  }
  return image;
}

Image Film::mean() const {
  return image_of([](const FilmTile& tile, std::size_t i) { return tile.mean(i); });
}

Image Film::variance() const {
  return image_of([](const FilmTile& tile, std::size_t i) { return tile.variance(i); });
}

std::optional<ErrorEstimate> Film::error_estimate() const {
  ErrorSums sums;
  for (const TileState& tile : tiles_) sums += tile.error_sums;
  return error_estimate_of(sums);
}

std::optional<double> Film::estimated_error() const {
  const auto estimate = error_estimate();
  return estimate ? std::optional(estimate->error) : std::nullopt;
}

}  // namespace transport
