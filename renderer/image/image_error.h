// Image error metrics compare an image with a reference image.
#pragma once

#include <cstddef>
#include <optional>

#include "renderer/image/image.h"

namespace image {

/// relMSE adds this constant to its denominator, so that the error of dark pixels is bounded.
inline constexpr double RelmseFloor = 0.01;

/// Error metrics; means are over pixels and channels, without the pixels that are not finite in both images.
struct ImageError {
  double rmse = 0;    ///< square root of the mean squared difference
  double relmse = 0;  ///< mean of difference^2 / (reference^2 + RelmseFloor)
  /// The thesis' error (section 5.4): the mean of |difference| / reference over the pixels whose radiance is
  /// not zero in the reference; the channels of a pixel are summed first. Empty if all are black.
  std::optional<double> average_relative_error;
  /// Peak signal-to-noise ratio in dB, with the reference's largest value as the peak; empty if it is
  /// infinite or undefined: the images are equal, or the reference is black.
  std::optional<double> psnr;
  double max = 0;              ///< largest absolute difference of a channel
  std::size_t nan_pixels = 0;  ///< pixels that are not finite in one of the images
  /// Fireflies: pixels more than four times as bright as the reference's brightest one within two pixels, and
  /// brighter than a tenth of its mean. Noise in a lamp's penumbra stays below that; a path that hits a lamp
  /// by chance does not.
  std::size_t fireflies = 0;
};

/// Compares images of the same size. All values are 0 if no pixel counts.
ImageError error_of(const Image& image, const Image& reference);

}  // namespace image
