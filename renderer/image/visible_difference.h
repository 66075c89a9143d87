// The visible difference of two images: what of it the eye sees at some distance from a screen.
#pragma once

#include <vector>

#include "grf/math.h"
#include "renderer/image/ciede2000.h"
#include "renderer/image/image.h"

namespace image {

/// How an image is seen.
struct Viewing {
  /// A full HD screen of 24 inches (0.277 mm per pixel) from 63 cm.
  static constexpr double DefaultPixelsPerDegree = 40;

  double exposure = 0;  ///< stops
  double pixels_per_degree = DefaultPixelsPerDegree;
};

/// An image as the eye resolves it, pixel by pixel, rows from the top.
using SeenImage = std::vector<Lab>;

/// Filters an image as S-CIELAB does (Zhang and Wandell 1996, "A spatial extension of CIELAB for digital
/// color image reproduction"): in their opponent colours, each with a sum of Gaussians that models its
/// contrast sensitivity, then CIELAB with the white D65. Radiance is that of an sRGB screen: after the
/// exposure it is clipped to 0 and 1, its black and its white. Outside the image is nothing: weights of the
/// Gaussians there are left out. Uses the threads of the enclosing loop.
SeenImage seen(const Image& image, const Viewing& viewing);

/// The CIEDE2000 differences of two images of the same size, a value per pixel.
std::vector<float> visible_differences(const SeenImage& image, const SeenImage& reference);

/// What there is to see of the difference of two images, in units of CIEDE2000.
struct VisibleDifference {
  double mean = 0;
  double percentile_95 = 0;  ///< below 1, 95 % of the pixels look the same
};

/// Summarises differences, of which there is at least one.
VisibleDifference summary_of(std::vector<float> differences);

/// The Gaussians of an opponent channel: weights, and spreads s of exp(-(r/s)^2) in degrees of visual angle.
struct OpponentFilter {
  struct Gaussian {
    double weight = 0;
    double spread = 0;
  };
  std::vector<Gaussian> gaussians;
};
/// The filters of luminance, red-green and blue-yellow.
const std::vector<OpponentFilter>& opponent_filters();
/// Converts XYZ to opponent colours.
grf::Vec3d opponent_of(const grf::Vec3d& xyz);

}  // namespace image
