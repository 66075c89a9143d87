#pragma once

#include <algorithm>
#include <cmath>

#include "renderer/reflectance/geometry.h"

namespace reflectance {

/// The direction outside of the light that arrives at the surface along w, which points up; a horizontal one
/// if it is totally reflected.
inline Vec3f refracted_out(const Vec3f& w, float n) {
  const float z2 = n * n * w.z * w.z - (n - 1) * (n + 1);
  return {n * w.x, n * w.y, w.z > 0 ? std::sqrt(std::max(0.0F, z2)) : 0};
}

/// Solid angle inside to that outside, for the light that leaves along v and came along w.
inline float inside_per_outside(const Vec3f& v, const Vec3f& w, float n) { return v.z / (n * n * w.z); }

}  // namespace reflectance
