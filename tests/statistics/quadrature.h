#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "renderer/reflectance/geometry.h"

namespace statistics {

using reflectance::Vec3f;

/// A rectangle of directions in z = cos(theta) and the azimuth phi, where area is solid angle.
struct Cell {
  double z0, z1, phi0, phi1;

  double area() const { return (z1 - z0) * (phi1 - phi0); }
  bool contains(const Vec3f& v) const {
    double phi = std::atan2(v.y, v.x);
    if (phi < 0) phi += 2 * std::numbers::pi;
    return v.z >= z0 && v.z <= z1 && phi >= phi0 && phi <= phi1;
  }
};

inline Vec3f direction_at(double z, double phi) {
  const double sine = std::sqrt(std::max(0.0, (1 - z) * (1 + z)));
  return Vec3f(static_cast<float>(sine * std::cos(phi)), static_cast<float>(sine * std::sin(phi)),
               static_cast<float>(z));
}

/// Adaptive quadrature over solid angle, for functions with one narrow peak at a known direction.
class Quadrature {
 public:
  using Function = std::function<double(const Vec3f&)>;

  /// Subdivides cells with the peak at least 10 times, so that it is not stepped over, and all cells at least
  /// `depth` times: a step that only cuts off a cell's corner would be missed.
  Quadrature(Function function, const Vec3f& peak, double tolerance, int depth = 0)
      : function_(std::move(function)), peak_(peak), tolerance_(tolerance), depth_(depth) {}

  double over(const Cell& cell) const { return refine(cell, gauss(cell), 0); }

  double over_hemisphere() const {
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
      for (int k = 0; k < 16; ++k) {
        sum += over({i / 8.0, (i + 1) / 8.0, k * std::numbers::pi / 8, (k + 1) * std::numbers::pi / 8});
      }
    }
    return sum;
  }

 private:
  // Integrates by the 3 x 3 Gauss-Legendre rule.
  double gauss(const Cell& cell) const {
    constexpr double Place[3] = {-0.7745966692414834, 0, 0.7745966692414834};
    constexpr double Weight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        const double z = (cell.z0 + cell.z1 + Place[i] * (cell.z1 - cell.z0)) / 2;
        const double phi = (cell.phi0 + cell.phi1 + Place[k] * (cell.phi1 - cell.phi0)) / 2;
        sum += Weight[i] * Weight[k] * function_(direction_at(z, phi));
      }
    }
    return sum * cell.area();
  }

  double refine(const Cell& cell, double estimate, int depth) const {
    const double z = (cell.z0 + cell.z1) / 2;
    const double phi = (cell.phi0 + cell.phi1) / 2;
    const Cell parts[4] = {{cell.z0, z, cell.phi0, phi},
                           {z, cell.z1, cell.phi0, phi},
                           {cell.z0, z, phi, cell.phi1},
                           {z, cell.z1, phi, cell.phi1}};
    double estimates[4];
    double sum = 0;
    for (int i = 0; i < 4; ++i) sum += estimates[i] = gauss(parts[i]);
    const bool must_divide = depth < depth_ || (depth < 10 && cell.contains(peak_));
    if (!must_divide && (depth >= 16 || std::abs(sum - estimate) <= tolerance_)) return sum;
    double refined = 0;
    for (int i = 0; i < 4; ++i) refined += refine(parts[i], estimates[i], depth + 1);
    return refined;
  }

  Function function_;
  Vec3f peak_;
  double tolerance_;
  int depth_;
};

}  // namespace statistics
