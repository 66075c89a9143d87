// Image statistics and difference images are computed in threads.
#pragma once

#include <cstddef>

#include "renderer/image/image.h"

namespace editor {

/// Counts of invalid pixels, each counted once for the first category that applies, and luminance statistics.
struct ImageStatistics {
  std::size_t nan_pixels = 0;
  std::size_t infinite_pixels = 0;
  std::size_t negative_pixels = 0;  ///< negative in one of their channels
  double mean_luminance = 0;        ///< mean of the finite pixels
  /// The 0.1 % and 99.9 % percentiles of luminance; 0 for a black image.
  double dark_luminance = 0;
  double bright_luminance = 0;
  /// The least and the largest value of a channel in the finite pixels; 0 if there are none.
  float least_value = 0;
  float largest_value = 0;
};

ImageStatistics statistics_of(const image::Image& image);

enum class Difference {
  Signed,    ///< a - b
  Absolute,  ///< |a - b|
  Relative,  ///< |a - b| / sqrt(b^2 + 0.01): squared and averaged, it is relMSE
};

/// Computes the difference per channel. The images must have the same size.
image::Image difference_of(const image::Image& image, const image::Image& reference, Difference difference);

}  // namespace editor
