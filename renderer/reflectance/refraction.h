#pragma once

#include <algorithm>
#include <cmath>

#include "renderer/reflectance/geometry.h"

namespace reflectance {

/// Refracts light that arrives at the surface from inside along w, which points up. The result is horizontal
/// for total internal reflection.
inline Vec3f refracted_out(const Vec3f& w, float n) {
  const float z2 = n * n * w.z * w.z - (n - 1) * (n + 1);
  return {n * w.x, n * w.y, w.z > 0 ? std::sqrt(std::max(0.0F, z2)) : 0};
}

/// Returns the ratio of solid angles inside to outside, for light that came along w and leaves along v.
inline float inside_per_outside(const Vec3f& v, const Vec3f& w, float n) { return v.z / (n * n * w.z); }

}  // namespace reflectance
