#include "renderer/transport/error_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "renderer/parallel/loops.h"

namespace transport {
namespace {

/// A value per pixel, and how many pixels it is the sum of.
struct KnownSums {
  std::vector<double> values;
  std::vector<double> counts;

  explicit KnownSums(std::size_t pixels) : values(pixels), counts(pixels) {}
  void add(std::size_t to, const KnownSums& from, std::size_t pixel) {
    values[to] += from.values[pixel];
    counts[to] += from.counts[pixel];
  }
};

/// The film's pixels so far, and which of them have samples of both halves.
struct FilmPixels {
  PixelMoments moments;
  std::vector<bool> are_known;
};

/// Copies the pixels by tile; `copy_tile` copies one.
template <class CopyTile>
FilmPixels pixels_of(const Film& film, CopyTile copy_tile) {
  FilmPixels pixels{{{0, 0, film.width(), film.height()}, 0, {}, {}}, {}};
  const std::size_t count = pixels.moments.bounds.pixel_count();
  pixels.moments.means.resize(count);
  pixels.moments.variances.resize(count);
  pixels.are_known.resize(count);
  FilmTile tile;
  for (int i = 0; i < film.tile_count(); ++i) {
    copy_tile(i, tile);
    const bool is_known = tile.counts[0] > 0 && tile.counts[1] > 0;
    for (std::size_t p = 0; p < tile.bounds.pixel_count(); ++p) {
      const auto width = static_cast<std::size_t>(tile.bounds.width);
      const std::size_t to = pixels.moments.index_of(tile.bounds.x + static_cast<int>(p % width),
                                                     tile.bounds.y + static_cast<int>(p / width));
      pixels.moments.means[to] = Imath::V3d(tile.mean(p));
      pixels.moments.variances[to] = Imath::V3d(tile.variance(p));
      pixels.are_known[to] = is_known;
    }
  }
  return pixels;
}

KnownSums errors_of(const FilmPixels& pixels, const std::function<bool()>& stops) {
  const TileBounds& bounds = pixels.moments.bounds;
  KnownSums sums(bounds.pixel_count());
  parallel::for_each_index(bounds.height, [&](int y) {
    if (stops()) return;
    for (int x = 0; x < bounds.width; ++x) {
      const std::size_t pixel = pixels.moments.index_of(x, y);
      if (!pixels.are_known[pixel]) continue;
      sums.values[pixel] = squared_error_of(pixels.moments, {x, y});
      sums.counts[pixel] = 1;
    }
  });
  return sums;
}

/// Sums over the pixels within the radius along a row (`step` (1, 0)) or a column.
KnownSums summed(const KnownSums& sums, const TileBounds& bounds, const Imath::V2i& step) {
  KnownSums result(bounds.pixel_count());
  parallel::for_each_index(bounds.height, [&](int y) {
    for (int x = 0; x < bounds.width; ++x) {
      for (int i = -ErrorMapRadius; i <= ErrorMapRadius; ++i) {
        const Imath::V2i from = Imath::V2i(x, y) + step * i;
        const bool is_inside = from.x >= 0 && from.x < bounds.width && from.y >= 0 && from.y < bounds.height;
        if (is_inside) result.add(bounds.index_of(x, y), sums, bounds.index_of(from.x, from.y));
      }
    }
  });
  return result;
}

std::vector<float> map_of(const FilmPixels& pixels, const std::function<bool()>& stops) {
  const TileBounds& bounds = pixels.moments.bounds;
  std::vector<float> map(bounds.pixel_count(), std::numeric_limits<float>::infinity());
  const KnownSums of_rows = summed(errors_of(pixels, stops), bounds, {1, 0});
  const KnownSums sums = summed(of_rows, bounds, {0, 1});
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (pixels.are_known[i]) map[i] = static_cast<float>(std::sqrt(sums.values[i] / sums.counts[i]));
  }
  return map;
}

}  // namespace

std::vector<float> error_map(const Render& render, const std::function<bool()>& stops) {
  const FilmPixels pixels =
      pixels_of(render.film(), [&](int tile, FilmTile& copy) { render.copy_tile(tile, copy); });
  std::vector<float> map;
  parallel::run_with_threads(render.settings().threads, [&] { map = map_of(pixels, stops); });
  return stops() ? std::vector<float>() : map;
}

std::vector<float> error_map(const Film& film) {
  const FilmPixels pixels = pixels_of(film, [&](int tile, FilmTile& copy) { film.copy_tile(tile, copy); });
  return map_of(pixels, [] { return false; });
}

}  // namespace transport
