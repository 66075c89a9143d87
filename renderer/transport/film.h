#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/reflectance/geometry.h"
#include "renderer/transport/error_estimate.h"
#include "renderer/transport/image/image.h"
#include "renderer/transport/tile_bounds.h"

namespace transport {

using reflectance::Rgb;

/// The sums of one tile, which a worker takes out of the film, adds samples to, and puts back. All pixels of
/// a tile have as many samples.
struct FilmTile {
  static constexpr int Scramblings = 2;

  // Double, so that a million samples lose nothing.
  using PixelSums = std::array<Imath::V3d, Scramblings>;
  using Counts = std::array<std::uint32_t, Scramblings>;

  TileBounds bounds;
  Counts counts = {};
  std::vector<PixelSums> pixels;  ///< rows from the top
  /// Of each half, how noisy it is: `spread_since` of its pilot; see SamplePlacement.
  std::array<double, Scramblings> spreads = {};

  std::uint32_t sample_count() const { return counts[0] + counts[1]; }

  /// Adds to the sums of a pixel, by its place within the tile. A sample that is not finite counts as black
  /// and is reported: returns false. The counts are not touched, because they are of all pixels.
  bool add(int x, int y, int scrambling, const Rgb& radiance);

  /// The mean of all samples; black without any. If the halves' counts differ by more than one sample, each
  /// half weighs the same: a weight that followed from counts which samples decided would favour some values.
  Rgb mean(std::size_t pixel) const;
  /// The variance of that mean, from the two halves; 0 while there is but one.
  Rgb variance(std::size_t pixel) const;
  /// Returns what the tile by itself says of the error, without the pixels around it: enough to show how a
  /// render goes. Zeros while there is only one half.
  ErrorSums error_sums() const;
  /// The sum over pixels and channels of the relative variance of one sample of a half, as far as the samples
  /// before and after a moment tell: `before` is the tile as it was then. Both must be of at least one
  /// sample.
  double spread_since(const FilmTile& before, int scrambling) const;
};

/// Where the samples of an image are added up. Each pixel keeps two sums, of samples from two independent
/// scramblings of the point sequence: samples of one sequence are not independent, so the error of a pixel
/// comes from how far the two means are apart.
///
/// A tile's pixels lie together, so that workers on different tiles share no cache line; a pixel takes 48
/// bytes, so an image of 16384 x 16384 pixels 13 GB.
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
  /// That of a pixel.
  int tile_of(int x, int y) const { return y / TileSize * tiles_across() + x / TileSize; }
  TileBounds bounds_of(int tile) const;
  const FilmTile::Counts& counts_of(int tile) const { return tiles_[index(tile)].counts; }
  std::uint32_t sample_count_of(int tile) const { return counts_of(tile)[0] + counts_of(tile)[1]; }
  const std::array<double, Scramblings>& spreads_of(int tile) const { return tiles_[index(tile)].spreads; }
  const ErrorSums& error_sums_of(int tile) const { return tiles_[index(tile)].error_sums; }

  /// Copies a tile; what the copy held is overwritten.
  void copy_tile(int tile, FilmTile& copy) const;
  void put_back(int tile, const FilmTile& copy) { put_back(tile, copy, copy.error_sums()); }
  /// Puts a tile back with its `error_sums()`, computed before the caller takes a lock: they take the
  /// longest.
  void put_back(int tile, const FilmTile& copy, const ErrorSums& error_sums);

  /// How many samples a pixel has.
  std::uint32_t sample_count(int x, int y) const;

  /// The mean of all samples; a pixel without any is black.
  Image mean() const;

  /// The variance of each pixel's mean, from its two halves; 0 for a pixel that has but one.
  Image variance() const;

  /// Estimates the error of the image, on the threads of the loop that it is called in; empty while no pixel
  /// has both halves. A tile that has only one does not count.
  std::optional<ErrorEstimate> error_estimate() const;
  std::optional<double> estimated_error() const;

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
  template <class Function>
  Image image_of(Function function) const;

  int width_;
  int height_;
  std::vector<TileState> tiles_;
  std::vector<FilmTile::PixelSums> pixels_;  ///< tile after tile
};

/// Writes a tile's values, of which `function` gives one for each pixel's index, to their place in an image.
template <class Function>
void write_tile(const TileBounds& bounds, Function function, Image& image) {
  std::size_t from = 0;
  for (int y = bounds.y; y < bounds.y + bounds.height; ++y) {
    std::size_t to = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(bounds.x);
    for (int x = 0; x < bounds.width; ++x) image.pixels[to++] = function(from++);
  }
}

}  // namespace transport
