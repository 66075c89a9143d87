// Piecewise-linear cdfs are built over a row of cells, and inverted.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace reflectance {

/// Returns the cdf at the cells' edges, from 0 to 1: one number more than there are cells. Uniform if all
/// masses are 0. Masses must be finite and >= 0.
inline std::vector<float> cumulative(std::span<const double> masses) {
  double sum = 0;
  for (const double mass : masses) sum += mass;
  std::vector<float> curve = {0};
  double below = 0;
  for (const double mass : masses) {
    below += sum > 0 ? mass / sum : 1.0 / static_cast<double>(masses.size());
    curve.push_back(std::min(1.0F, static_cast<float>(below)));
  }
  // The last cell that has a mass takes the rounding error, so that an empty one stays empty.
  for (std::size_t i = curve.size() - 1; i > 0; --i) {
    curve[i] = 1;
    if (!(sum > 0) || masses[i - 1] > 0) break;
  }
  return curve;
}

/// The position where a cdf takes a value: the cell, and the fraction of the way into it, 0 to 1.
struct CdfPosition {
  std::size_t cell = 0;
  float fraction = 0;
};

/// Inverts a cdf at xi in [0,1). The result is never in a cell without mass.
inline CdfPosition inverted(std::span<const float> curve, float xi) {
  const auto above = std::upper_bound(curve.begin() + 1, curve.end() - 1, xi);
  const auto cell = static_cast<std::size_t>(above - curve.begin()) - 1;
  return {cell, (xi - curve[cell]) / (curve[cell + 1] - curve[cell])};
}

/// Simplifies a rising curve (x, y) by the algorithm of Douglas and Peucker (1973) and returns the indices of
/// the points kept, with both ends. The error is at most the tolerance in y, not across the line, since y is
/// a probability and x is not.
std::vector<std::uint16_t> simplified(std::span<const float> x, std::span<const float> y, float tolerance);

}  // namespace reflectance
