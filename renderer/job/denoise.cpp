#include "renderer/job/denoise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "renderer/parallel/loops.h"

namespace job {
namespace {

using image::Image;
using reflectance::Rgb;
using transport::FeatureLayers;

/// The filter reaches 2 * (2^5 - 1) = 62 pixels.
constexpr int Levels = 5;
/// The cubic B-spline, as in the paper.
constexpr std::array<float, 3> Spline = {3 / 8.0F, 1 / 4.0F, 1 / 16.0F};  // by the distance from the centre
// Edge-stopping widths: squares of sigma. The colour's is in variances of a pixel's mean; it shrinks by a
// factor of 4 per level, as the paper halves sigma.
constexpr float NormalWidth = 0.05F;
constexpr float AlbedoWidth = 0.01F;
constexpr float DepthWidth = 1e-4F;  // of the relative difference per pixel of distance, on a slope
constexpr float ColourWidth = 36;

float squared(const Rgb& value) { return value.dot(value); }

/// One level of the transform.
class Level {
 public:
  Level(const Image& image, const Image& variance, const FeatureLayers& guides, int level, bool is_known)
      : image_(image),
        variance_(variance),
        guides_(guides),
        step_(1 << level),
        colour_width_(ColourWidth * std::pow(0.25F, static_cast<float>(level))),
        is_known_(is_known) {}

  Rgb filtered(int x, int y) const {
    const std::size_t centre = index(x, y);
    const float width = colour_width_ * squared_deviation(x, y);
    Rgb sum(0);
    float weights = 0;
    for (int j = -2; j <= 2; ++j) {
      for (int i = -2; i <= 2; ++i) {
        const int column = x + i * step_;
        const int row = y + j * step_;
        if (column < 0 || row < 0 || column >= image_.width || row >= image_.height) continue;
        const std::size_t other = index(column, row);
        const float distance = guide_distance(centre, other, std::max(std::abs(i), std::abs(j))) +
                               colour_distance(centre, other, width);
        const float spline =
            Spline[static_cast<std::size_t>(std::abs(i))] * Spline[static_cast<std::size_t>(std::abs(j))];
        const float weight = spline * std::exp(-distance);
        sum += weight * image_.pixels[other];
        weights += weight;
      }
    }
    return sum / weights;  // the centre's weight is 9/64
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x);
  }

  /// The variance about a pixel: that of one pixel is too noisy itself.
  float squared_deviation(int x, int y) const {
    float sum = 0;
    int count = 0;
    for (int row = std::max(0, y - 1); row <= std::min(image_.height - 1, y + 1); ++row) {
      for (int column = std::max(0, x - 1); column <= std::min(image_.width - 1, x + 1); ++column) {
        const Rgb& value = variance_.at(column, row);
        sum += value.x + value.y + value.z;
        ++count;
      }
    }
    return sum / static_cast<float>(count);
  }

  float colour_distance(std::size_t a, std::size_t b, float width) const {
    if (!is_known_) return 0;
    constexpr float Least = 1e-10F;
    return squared(image_.pixels[a] - image_.pixels[b]) / (width + Least);
  }

  float guide_distance(std::size_t a, std::size_t b, int steps) const {
    const float depth = guides_.depth[a];
    const float other = guides_.depth[b];
    const bool is_hit = std::isfinite(depth);
    if (is_hit != std::isfinite(other)) return std::numeric_limits<float>::infinity();
    if (!is_hit || a == b) return 0;
    const float slope = (depth - other) / (std::max(depth, other) * static_cast<float>(steps * step_));
    return squared(guides_.normal.pixels[a] - guides_.normal.pixels[b]) / NormalWidth +
           squared(guides_.albedo.pixels[a] - guides_.albedo.pixels[b]) / AlbedoWidth +
           slope * slope / DepthWidth;
  }

  const Image& image_;
  const Image& variance_;
  const FeatureLayers& guides_;
  int step_;
  float colour_width_;
  bool is_known_;
};

}  // namespace

Image denoised(const Image& noisy, const Image& variance, bool is_variance_known, const FeatureLayers& guides,
               const std::function<bool()>& stops) {
  Image image = noisy;
  Image next = noisy;
  for (int i = 0; i < Levels; ++i) {
    if (stops()) return noisy;
    const Level level(image, variance, guides, i, is_variance_known);
    parallel::for_each_index(image.height, [&](int y) {
      for (int x = 0; x < image.width; ++x) {
        next.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                    static_cast<std::size_t>(x)] = level.filtered(x, y);
      }
    });
    std::swap(image, next);
  }
  return image;
}

}  // namespace job
