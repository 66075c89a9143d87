#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct TransmissionFormula {
  static real sqrt(real x) { return std::sqrt(x); }
  static real max(real a, real b) { return std::max(a, b); }
#include "renderer/reflectance/transmission.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// A Transmission tabulates what a layer transmits to the BRDF below it: a factor t(u) t(v) that treats both
/// directions alike, where t depends on the cosine of the direction, and is linear between the rows.
class Transmission {
 public:
  static constexpr std::size_t Rows = 17;
  using Table = std::array<Rgb, Rows>;

  explicit Transmission(const Table& table);

  /// Returns the cosine of a row. Rows are denser towards grazing, where layers transmit less.
  static float cosine(std::size_t row) {
    const float root = static_cast<float>(row) / (Rows - 1);
    return root * root;
  }

  /// Interpolates a table at the cosine of a direction.
  template <class Real>
  static Vec3<Real> interpolate(const Table& table, Real c) {
    glsl::TransmissionFormula<Real> formula;
    const int row = formula.transmission_row(c);
    const Vec3<Real> below(table[static_cast<std::size_t>(row)]);
    const Vec3<Real> above(table[static_cast<std::size_t>(row) + 1]);
    return below + (above - below) * formula.transmission_fraction(c, row);
  }

  /// Returns t(u) t(v).
  template <class Real>
  Vec3<Real> factor(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return interpolate(table_, u.z) * interpolate(table_, v.z);
  }

  /// Estimates the mean of t(u) t(v) over the directions v, for choosing lobes.
  float estimate(const Vec3f& u) const { return mean(interpolate(table_, u.z)) * mean_; }

  const Table& table() const { return table_; }

  /// Returns what is transmitted through this layer and another one.
  Transmission through(const Transmission& other) const;

 private:
  Table table_;
  float mean_ = 0;  ///< over the hemisphere, weighted by the cosine
};

}  // namespace reflectance
