#pragma once

#include <algorithm>
#include <cmath>

#include "grf/math.h"

namespace editor {

/// A square on the plane y = 0 about the origin, in steps of a power of ten.
struct GroundGrid {
  double step = 1;
  double half_size = 10;
};

/// One that reaches somewhat further than the scene, with 10 to 100 steps.
inline GroundGrid ground_grid(const grf::Box3d& bounds) {
  if (bounds.isEmpty()) return {};
  double reach = bounds.size().length() / 2;
  for (const double x : {bounds.min.x, bounds.max.x, bounds.min.z, bounds.max.z}) {
    reach = std::max(reach, std::min(std::abs(x), 4 * bounds.size().length()));
  }
  reach = std::max(reach, 1e-6);
  const double step = std::pow(10, std::floor(std::log10(reach * 1.2)));
  const double finer = reach * 1.2 < 3 * step ? step / 5 : step;
  return {finer, std::ceil(reach * 1.2 / finer) * finer};
}

}  // namespace editor
