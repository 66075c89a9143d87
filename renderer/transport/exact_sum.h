#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "renderer/reflectance/geometry.h"

namespace transport {

/// A sum of floats that is exact, and so the same whatever the order and the grouping of its terms: parts of
/// an image that several threads or machines render add up to the same bits.
///
/// It is a fixed-point number of 128 bits with steps of 2^-60. A term is rounded to a multiple of that, which
/// any float of at least 2^-37 is. Terms are below `Limit`, of which 2^27 fit into a sum.
class ExactSum {
 public:
  static constexpr float Limit = 0x1p40F;

  /// Adds a finite term, whose absolute value is below `Limit`.
  void add(float term) {
    const double steps = double(term) * Steps;  // exact: a power of two changes the exponent alone
    sum_ += std::abs(steps) < 0x1p62 ? Integer(std::llrint(steps)) : Integer(steps);
  }
  ExactSum& operator+=(const ExactSum& other) {
    sum_ += other.sum_;
    return *this;
  }
  ExactSum& operator-=(const ExactSum& other) {
    sum_ -= other.sum_;
    return *this;
  }
  bool operator==(const ExactSum&) const = default;

  /// The nearest double.
  double value() const { return static_cast<double>(sum_) / Steps; }

 private:
  __extension__ using Integer = __int128;
  static constexpr double Steps = 0x1p60;

  Integer sum_ = 0;
};

/// The exact sum of radiances, or of other colours.
class ExactRgbSum {
 public:
  /// Whether a colour can be added: not if a channel is not finite, or too large.
  static bool can_add(const reflectance::Rgb& term) {
    const auto fits = [](float channel) { return std::abs(channel) < ExactSum::Limit; };  // false for NaN
    return fits(term.x) && fits(term.y) && fits(term.z);
  }

  /// Adds a colour that can be added.
  void add(const reflectance::Rgb& term) {
    for (int channel = 0; channel < 3; ++channel)
      channels_[static_cast<std::size_t>(channel)].add(term[channel]);
  }
  ExactRgbSum& operator+=(const ExactRgbSum& other) {
    for (std::size_t i = 0; i < channels_.size(); ++i) channels_[i] += other.channels_[i];
    return *this;
  }
  ExactRgbSum& operator-=(const ExactRgbSum& other) {
    for (std::size_t i = 0; i < channels_.size(); ++i) channels_[i] -= other.channels_[i];
    return *this;
  }
  bool operator==(const ExactRgbSum&) const = default;

  Imath::V3d value() const { return {channels_[0].value(), channels_[1].value(), channels_[2].value()}; }

 private:
  std::array<ExactSum, 3> channels_;
};

}  // namespace transport
