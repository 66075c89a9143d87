// How far an image is from another one.
#pragma once

#include <cstddef>
#include <optional>

#include "renderer/transport/image/image.h"

namespace transport {

/// Means are over pixels and channels, in which pixels that are not finite in both images do not count.
struct ImageError {
  double rmse = 0;    ///< square root of the mean squared difference
  double relmse = 0;  ///< mean of difference^2 / (reference^2 + 0.01)
  /// The thesis' (section 5.4): the mean of |difference| / reference over the pixels whose radiance is not
  /// null in the reference. Of a pixel, the channels of both are added up. Nothing if all is black.
  std::optional<double> average_relative_error;
  /// Peak signal-to-noise ratio in dB, with the reference's largest value as the peak; nothing where the
  /// images are the same, or the reference is black: it has no finite value.
  std::optional<double> psnr;
  double max = 0;              ///< the largest difference of a channel
  std::size_t nan_pixels = 0;  ///< that are not finite in one of the images
  /// Pixels over four times as bright as the brightest of the reference's within two pixels of them, and than
  /// a tenth of its mean. Noise of the lamp's penumbra does not reach that; a path that met a lamp by chance
  /// does.
  std::size_t fireflies = 0;
};

/// The images must be of one size. All is 0 if no pixel counts.
ImageError error_of(const Image& image, const Image& reference);

}  // namespace transport
