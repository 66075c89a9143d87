#include "editor/image/image_statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "editor/image/screen_colours.h"
#include "renderer/reflectance/geometry.h"

namespace editor {
namespace {

using grf::Colour;

/// Enough for a percentile of 0.1 %, and quickly sorted.
constexpr std::size_t MostSamples = 1 << 18;

/// Whether the luminance of the pixel counts.
bool count(const Colour& pixel, ImageStatistics& statistics) {
  if (std::isnan(pixel.x) || std::isnan(pixel.y) || std::isnan(pixel.z)) {
    ++statistics.nan_pixels;
    return false;
  }
  if (std::isinf(pixel.x) || std::isinf(pixel.y) || std::isinf(pixel.z)) {
    ++statistics.infinite_pixels;
    return false;
  }
  if (pixel.x < 0 || pixel.y < 0 || pixel.z < 0) ++statistics.negative_pixels;
  return true;
}

float difference_of(float a, float b, Difference difference) {
  if (difference == Difference::Signed) return a - b;
  const float distance = std::abs(a - b);
  return difference == Difference::Absolute ? distance : distance / std::sqrt(b * b + 0.01F);
}

}  // namespace

ImageStatistics statistics_of(const image::Image& image) {
  ImageStatistics statistics;
  std::vector<float> lit;
  double sum = 0;
  std::size_t finite = 0;
  const std::size_t step = 1 + image.pixels.size() / MostSamples;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (!count(image.pixels[i], statistics)) continue;
    const double luminance = reflectance::luminance(image.pixels[i]);
    sum += luminance;
    if (finite == 0) statistics.least_value = statistics.largest_value = image.pixels[i].x;
    for (const float value : {image.pixels[i].x, image.pixels[i].y, image.pixels[i].z}) {
      statistics.least_value = std::min(statistics.least_value, value);
      statistics.largest_value = std::max(statistics.largest_value, value);
    }
    ++finite;
    if (i % step == 0 && luminance > 0) lit.push_back(static_cast<float>(luminance));
  }
  if (finite > 0) statistics.mean_luminance = sum / static_cast<double>(finite);
  if (lit.empty()) return statistics;
  const auto ranked = [&](double share) {
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(lit.size() - 1));
    std::nth_element(lit.begin(), lit.begin() + rank, lit.end());
    return lit[static_cast<std::size_t>(rank)];
  };
  statistics.dark_luminance = ranked(0.001);
  statistics.bright_luminance = ranked(0.999);
  return statistics;
}

image::Image difference_of(const image::Image& image, const image::Image& reference, Difference difference) {
  assert(image.width == reference.width && image.height == reference.height);
  image::Image result{image.width, image.height, std::vector<Colour>(image.pixels.size())};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      result.pixels[i][k] = difference_of(image.pixels[i][k], reference.pixels[i][k], difference);
    }
  }
  return result;
}

}  // namespace editor
