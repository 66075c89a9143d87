#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grf/math.h"

namespace grf {

/// Returns the eye of a view that frames a box, looking at its centre: from the front (looking along -z) and
/// slightly above. The field of view is vertical, in degrees, and the aspect is width over height.
inline Vec3d framing_eye(const Box3d& bounds, double field_of_view, double aspect) {
  if (bounds.isEmpty()) return {0, 0, 1};
  const double radius = bounds.size().length() > 0 ? bounds.size().length() / 2 : 1e-6;
  const double tangent = std::tan(field_of_view * std::numbers::pi / 360) * std::min(1.0, aspect);
  const double sine = tangent / std::sqrt(1 + tangent * tangent);
  return bounds.center() + Vec3d(0, 0.35, 1).normalized() * (radius / sine);
}

}  // namespace grf
