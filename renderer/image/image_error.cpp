#include "renderer/image/image_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace image {
namespace {

using grf::Colour;

bool is_finite_pixel(const Colour& pixel) {
  return std::isfinite(pixel.x) && std::isfinite(pixel.y) && std::isfinite(pixel.z);
}

/// Sums over pixels; double, so that many small terms count.
struct Sums {
  double squares = 0;
  double relative_squares = 0;
  double relative = 0;
  std::size_t pixels = 0;
  std::size_t lit_pixels = 0;
  double peak = 0;
  double largest = 0;

  void add(const Colour& pixel, const Colour& reference) {
    double difference = 0;
    double radiance = 0;
    for (int i = 0; i < 3; ++i) {
      const double expected = reference[i];
      const double d = std::abs(pixel[i] - expected);
      squares += d * d;
      relative_squares += d * d / (expected * expected + RelmseFloor);
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

/// The brightness of a pixel; empty if it is not finite.
double brightness(const Colour& pixel) {
  return is_finite_pixel(pixel) ? (static_cast<double>(pixel.x) + pixel.y + pixel.z) / 3 : 0;
}

double mean_brightness(const Image& image) {
  double sum = 0;
  for (const Colour& pixel : image.pixels) sum += brightness(pixel);
  return sum / static_cast<double>(image.pixels.size());
}

/// The brightest pixel within two pixels of one.
double brightest_near(const Image& image, int x, int y) {
  constexpr int Radius = 2;
  double brightest = 0;
  for (int j = std::max(0, y - Radius); j <= std::min(image.height - 1, y + Radius); ++j) {
    for (int i = std::max(0, x - Radius); i <= std::min(image.width - 1, x + Radius); ++i) {
      brightest = std::max(brightest, brightness(image.at(i, j)));
    }
  }
  return brightest;
}

std::size_t fireflies(const Image& image, const Image& reference) {
  constexpr double Factor = 4;
  const double least = 0.1 * mean_brightness(reference);
  std::size_t count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double here = brightness(image.at(x, y));
      if (here > Factor * least && here > Factor * brightest_near(reference, x, y)) ++count;
    }
  }
  return count;
}

}  // namespace

ImageError error_of(const Image& image, const Image& reference) {
  assert(image.width == reference.width && image.height == reference.height);
  Sums sums;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (is_finite_pixel(image.pixels[i]) && is_finite_pixel(reference.pixels[i])) {
      sums.add(image.pixels[i], reference.pixels[i]);
    }
  }
  ImageError error;
  error.nan_pixels = image.pixels.size() - sums.pixels;
  if (sums.pixels == 0) return error;
  error.fireflies = fireflies(image, reference);
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

}  // namespace image
