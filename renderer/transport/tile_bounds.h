#pragma once

#include <cstddef>

namespace transport {

/// A rectangle of pixels of an image.
struct TileBounds {
  int x = 0;  ///< of the upper left pixel
  int y = 0;
  int width = 0;
  int height = 0;

  std::size_t pixel_count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  /// Row by row, of a place within.
  std::size_t index_of(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
};

}  // namespace transport
