#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/image/image.h"
#include "renderer/reflectance/geometry.h"
#include "renderer/transport/error_estimate.h"
#include "renderer/transport/exact_sum.h"
#include "renderer/transport/tile_bounds.h"

namespace transport {

using reflectance::Rgb;

/// The sums of one tile, which a worker copies out of the film, adds samples to, and puts back. All pixels of
/// a tile have the same number of samples.
struct FilmTile {
  static constexpr int Scramblings = 2;

  using PixelSums = std::array<ExactRgbSum, Scramblings>;
  using Counts = std::array<std::uint32_t, Scramblings>;

  TileBounds bounds;
  Counts counts = {};
  std::vector<PixelSums> pixels;  ///< rows from the top
  /// The noisiness of each half: `spread_since` over its pilot; see AdaptiveSampling.
  std::array<double, Scramblings> spreads = {};

  std::uint32_t sample_count() const { return counts[0] + counts[1]; }

  /// Adds to the sums of a pixel, given its position within the tile. A sample that is not finite, or at
  /// least `ExactSum::Limit`, counts as black, and false is returned. The counts stay, because they are those
  /// of all pixels.
  bool add(int x, int y, int scrambling, const Rgb& radiance);

  /// The mean of all samples; black if there are none. If the halves' counts differ by more than one sample,
  /// both halves weigh the same: a weight that depends on adaptive sample counts would bias the mean.
  Rgb mean(std::size_t pixel) const;
  /// The variance of that mean, estimated from the two halves; 0 while there is only one.
  Rgb variance(std::size_t pixel) const;
  /// The difference of the halves, scaled to have the variance of the mean; 0 while there is only one.
  Rgb half_difference(std::size_t pixel) const;
  /// Returns the tile's own contribution to the error, without the pixels around it: good enough to show
  /// progress. Zeros while there is only one half.
  ErrorSums error_sums() const;
  /// The sum over pixels and channels of the relative variance of one sample of a half, estimated from the
  /// samples before and after a moment: `before` is the tile at that time. Both parts need at least one
  /// sample.
  double spread_since(const FilmTile& before, int scrambling) const;
};

/// The film accumulates an image's samples. Each pixel keeps two sums, of samples with two independent
/// scramblings of the sequence: samples of one sequence are not independent, so the error of a pixel is
/// estimated from the difference of the two means.
///
/// The pixels of a tile are contiguous, so that workers on different tiles share no cache line. A pixel takes
/// 96 bytes, an image of 16384 x 16384 pixels 26 GB.
class Film {
 public:
  static constexpr int Scramblings = FilmTile::Scramblings;
  static constexpr int TileSize = 16;

  Film(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  // Tiles count from 0, row by row.
  int tiles_across() const { return (width_ + TileSize - 1) / TileSize; }
  int tiles_down() const { return (height_ + TileSize - 1) / TileSize; }
  int tile_count() const { return static_cast<int>(tiles_.size()); }
  /// The tile that contains a pixel.
  int tile_of(int x, int y) const { return y / TileSize * tiles_across() + x / TileSize; }
  TileBounds bounds_of(int tile) const;
  const FilmTile::Counts& counts_of(int tile) const { return tiles_[index(tile)].counts; }
  std::uint32_t sample_count_of(int tile) const { return counts_of(tile)[0] + counts_of(tile)[1]; }
  const std::array<double, Scramblings>& spreads_of(int tile) const { return tiles_[index(tile)].spreads; }
  const ErrorSums& error_sums_of(int tile) const { return tiles_[index(tile)].error_sums; }

  /// Copies a tile, overwriting `copy`.
  void copy_tile(int tile, FilmTile& copy) const;
  void put_back(int tile, const FilmTile& copy) { put_back(tile, copy, copy.error_sums()); }
  /// Puts a tile back with its `error_sums()`, which the caller computes before it takes a lock because they
  /// take the longest.
  void put_back(int tile, const FilmTile& copy, const ErrorSums& error_sums);

  /// The number of samples of a pixel.
  std::uint32_t sample_count(int x, int y) const;

  /// The mean of each pixel's samples; black without samples.
  image::Image mean() const;

  /// The variance of each pixel's mean, from its two halves; 0 for a pixel with only one.
  image::Image variance() const;

  /// Estimates the error of the image, on the threads of the enclosing loop; empty while no pixel has both
  /// halves. Tiles with only one half are left out.
  std::optional<ErrorEstimate> error_estimate() const;
  std::optional<double> estimated_error() const;

  /// The error of an image, estimated from a sample of its tiles.
  struct SampledError {
    ErrorEstimate estimate;  ///< as if the whole image had been rendered
    double deviation = 0;    ///< standard deviation of the error's logarithm due to the choice of tiles
  };
  /// Estimates the error of the whole image from the tiles with both halves; empty if there are none.
  std::optional<SampledError> sampled_error() const;

 private:
  struct TileState {
    FilmTile::Counts counts = {};
    std::array<double, Scramblings> spreads = {};
    ErrorSums error_sums;
  };

  static std::size_t index(int tile) { return static_cast<std::size_t>(tile); }
  std::size_t first_pixel(const TileBounds& bounds) const;
  bool has_both_halves(int column, int row) const;
  TileBounds with_neighbours(const TileBounds& bounds) const;
  ErrorSums sums_with_neighbours(int tile) const;
  std::vector<ErrorSums> sums_of_tiles() const;
  template <class Function>
  image::Image image_of(Function function) const;

  int width_;
  int height_;
  std::vector<TileState> tiles_;
  std::vector<FilmTile::PixelSums> pixels_;  ///< tile after tile
};

/// Writes a tile into an image; `function` returns the value for a pixel's index in the tile.
template <class Function>
void write_tile(const TileBounds& bounds, Function function, image::Image& image) {
  std::size_t from = 0;
  for (int y = bounds.y; y < bounds.y + bounds.height; ++y) {
    std::size_t to = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(bounds.x);
    for (int x = 0; x < bounds.width; ++x) image.pixels[to++] = function(from++);
  }
}

}  // namespace transport
