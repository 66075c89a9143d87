#include "renderer/transport/film.h"

#include <algorithm>
#include <cmath>

namespace transport {

bool FilmTile::add(int x, int y, int scrambling, const Rgb& radiance) {
  const bool finite = std::isfinite(radiance.x) && std::isfinite(radiance.y) && std::isfinite(radiance.z);
  if (!finite) return false;
  PixelSums& sums = pixels[static_cast<std::size_t>(y * bounds.width + x)];
  sums[static_cast<std::size_t>(scrambling)] += Imath::V3d(radiance);
  return true;
}

Rgb FilmTile::mean(std::size_t pixel) const { return Rgb(exact_mean(pixels[pixel])); }

Rgb FilmTile::variance(std::size_t pixel) const { return Rgb(exact_variance(pixels[pixel])); }

Imath::V3d FilmTile::exact_mean(const PixelSums& sums) const {
  const std::uint32_t count = sample_count();
  return count == 0 ? Imath::V3d(0) : (sums[0] + sums[1]) / count;
}

// The halves are independent estimates of the same value. For n and m samples, the variance of the mean of
// all is n m / (n + m)^2 of the mean squared difference of the two means: a quarter, if they are as many.
Imath::V3d FilmTile::exact_variance(const PixelSums& sums) const {
  const double n = counts[0];
  const double m = counts[1];
  if (n == 0 || m == 0) return Imath::V3d(0);
  const Imath::V3d difference = sums[0] / n - sums[1] / m;
  return difference * difference * (n * m / ((n + m) * (n + m)));
}

std::optional<double> FilmTile::error_sum() const {
  if (counts[0] == 0 || counts[1] == 0) return std::nullopt;
  double sum = 0;
  for (const PixelSums& sums : pixels) {
    const Imath::V3d average = exact_mean(sums);
    const Imath::V3d spread = exact_variance(sums);
    for (int i = 0; i < 3; ++i) sum += spread[i] / (average[i] * average[i] + 0.01);
  }
  return sum;
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
  const auto first = pixels_.begin() + static_cast<std::ptrdiff_t>(first_pixel(copy.bounds));
  copy.pixels.assign(first, first + static_cast<std::ptrdiff_t>(copy.bounds.pixel_count()));
}

void Film::put_back(int tile, const FilmTile& copy) {
  tiles_[index(tile)] = {copy.counts, copy.error_sum().value_or(0)};
  std::copy(copy.pixels.begin(), copy.pixels.end(),
            pixels_.begin() + static_cast<std::ptrdiff_t>(first_pixel(copy.bounds)));
}

std::uint32_t Film::sample_count(int x, int y) const {
  return sample_count_of(y / TileSize * tiles_across() + x / TileSize);
}

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

std::optional<double> Film::estimated_error() const {
  double sum = 0;
  std::size_t counted = 0;
  for (int tile = 0; tile < tile_count(); ++tile) {
    if (counts_of(tile)[0] == 0 || counts_of(tile)[1] == 0) continue;
    sum += error_sum_of(tile);
    counted += 3 * bounds_of(tile).pixel_count();
  }
  if (counted == 0) return std::nullopt;
  return std::sqrt(sum / static_cast<double>(counted));
}

}  // namespace transport
