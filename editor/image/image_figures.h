// Numbers about images, and images of their differences.
#pragma once

#include <cstddef>

#include "renderer/transport/image/image.h"

namespace editor {

/// Pixels are counted once, for the first of these that they are.
struct ImageFigures {
  std::size_t nan_pixels = 0;
  std::size_t infinite_pixels = 0;
  std::size_t negative_pixels = 0;  ///< in one of their channels
  double mean_luminance = 0;        ///< of finite pixels
  /// Luminances that one pixel in a thousand is below and above; of a black image 0.
  double dark_luminance = 0;
  double bright_luminance = 0;
};

ImageFigures figures_of(const transport::Image& image);

enum class Difference {
  Signed,    ///< a - b
  Absolute,  ///< |a - b|
  Relative,  ///< |a - b| / sqrt(b^2 + 0.01): squared and averaged, it is relMSE
};

/// Of each channel. The images must be of one size.
transport::Image difference_of(const transport::Image& image, const transport::Image& reference,
                               Difference difference);

}  // namespace editor
