// Distributions over a row of cells as curves that rise from 0 to 1, and their inversion.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace reflectance {

/// Sums of the masses of cells up to each edge, as shares of the whole: one number more than there are
/// cells, from 0 to 1. Even, if the masses are all 0. Masses are finite and >= 0.
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

/// Where a curve takes a value: the cell, and how far into it, 0 to 1.
struct CurvePlace {
  std::size_t cell = 0;
  float fraction = 0;
};

/// The inverse of a curve at xi in [0,1). It never falls on a cell without mass.
inline CurvePlace inverted(std::span<const float> curve, float xi) {
  const auto above = std::upper_bound(curve.begin() + 1, curve.end() - 1, xi);
  const auto cell = static_cast<std::size_t>(above - curve.begin()) - 1;
  return {cell, (xi - curve[cell]) / (curve[cell + 1] - curve[cell])};
}

/// The indices of the points that the algorithm of Douglas and Peucker (1973) keeps of a rising curve
/// (x, y), both ends among them. Lines between them are nowhere further from the curve than the tolerance:
/// in y and not across the line, since y is a probability and x is none.
std::vector<std::uint16_t> simplified(std::span<const float> x, std::span<const float> y, float tolerance);

}  // namespace reflectance
