#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/reflectance/geometry.h"
#include "renderer/transport/image/image.h"

namespace transport {

using reflectance::Rgb;

/// Where the samples of an image are added up. Each pixel keeps two sums, of samples from two independent
/// scramblings of the point sequence: samples of one sequence are not independent, so the error of a pixel
/// comes from how far the two means are apart.
class Film {
 public:
  static constexpr int Scramblings = 2;

  Film(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  /// Samples of one pixel must not be added by two threads at once. One that is not finite counts as black
  /// and is reported: returns false.
  bool add(int x, int y, int scrambling, const Rgb& radiance);

  /// How many samples a pixel has.
  std::uint32_t sample_count(int x, int y) const;

  /// The mean of all samples; a pixel without any is black.
  Image mean() const;

  /// The variance of each pixel's mean, from its two halves; 0 for a pixel that has but one.
  Image variance() const;

  /// The estimated error of the image, sqrt(relMSE) with relMSE = mean(variance / (mean^2 + 0.01)) over
  /// pixels and channels; nothing while no pixel has both halves.
  std::optional<double> estimated_error() const;

 private:
  struct Pixel {
    // Double, so that a million samples lose nothing.
    std::array<Imath::V3d, Scramblings> sum = {Imath::V3d(0), Imath::V3d(0)};
    std::array<std::uint32_t, Scramblings> count = {};
  };

  std::size_t index_of(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  static Imath::V3d mean_of(const Pixel& pixel);
  static Imath::V3d variance_of(const Pixel& pixel);

  int width_;
  int height_;
  std::vector<Pixel> pixels_;
};

}  // namespace transport
