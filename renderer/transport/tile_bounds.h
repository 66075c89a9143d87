#pragma once

#include <cstddef>

namespace transport {

/// A rectangle of pixels of an image.
struct TileBounds {
  int x = 0;  ///< upper left pixel
  int y = 0;
  int width = 0;
  int height = 0;

  std::size_t pixel_count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  /// The index of a pixel in row-major order, from its position in the rectangle.
  std::size_t index_of(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
};

}  // namespace transport
