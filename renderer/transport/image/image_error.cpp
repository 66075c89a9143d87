#include "renderer/transport/image/image_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace transport {
namespace {

using reflectance::Rgb;

bool is_finite(const Rgb& pixel) {
  return std::isfinite(pixel.x) && std::isfinite(pixel.y) && std::isfinite(pixel.z);
}

/// What is added up over pixels; double, so that many small ones count.
struct Sums {
  double squares = 0;
  double relative_squares = 0;
  double relative = 0;
  std::size_t pixels = 0;
  std::size_t lit_pixels = 0;
  double peak = 0;
  double largest = 0;

  void add(const Rgb& pixel, const Rgb& reference) {
    double difference = 0;
    double radiance = 0;
    for (int i = 0; i < 3; ++i) {
      const double expected = reference[i];
      const double d = std::abs(pixel[i] - expected);
      squares += d * d;
      relative_squares += d * d / (expected * expected + 0.01);
      difference += d;
      radiance += expected;
      peak = std::max(peak, expected);
      largest = std::max(largest, d);
    }
    ++pixels;
    if (radiance <= 0) return;
    relative += difference / radiance;
    ++lit_pixels;
  }
};

}  // namespace

ImageError error_of(const Image& image, const Image& reference) {
  assert(image.width == reference.width && image.height == reference.height);
  Sums sums;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (is_finite(image.pixels[i]) && is_finite(reference.pixels[i])) {
      sums.add(image.pixels[i], reference.pixels[i]);
    }
  }
  ImageError error;
  error.nan_pixels = image.pixels.size() - sums.pixels;
  if (sums.pixels == 0) return error;
  const double count = 3 * static_cast<double>(sums.pixels);
  error.rmse = std::sqrt(sums.squares / count);
  error.relmse = sums.relative_squares / count;
  error.max = sums.largest;
  if (sums.lit_pixels > 0) {
    error.average_relative_error = sums.relative / static_cast<double>(sums.lit_pixels);
  }
  if (error.rmse > 0 && sums.peak > 0) error.psnr = 20 * std::log10(sums.peak / error.rmse);
  return error;
}

}  // namespace transport
