// The lobe (n . h)^n about the half vector: what `blinn` and all that draw half vectors with a power share.
#pragma once

#include <cmath>

#include "renderer/reflectance/cosine_lobe.h"
#include "renderer/reflectance/geometry.h"

namespace reflectance {

/// A direction about z with density (n+1)/(2 pi) cos^n: cos = (1 - xi)^(1/(n+1)), by way of 1 - cos, which
/// narrow lobes need.
inline Vec3f power_direction(float n, const Vec2f& xi) {
  const float below_one = -std::expm1(std::log1p(-xi.x) / (n + 1));
  const float sine = std::sqrt(below_one * (2 - below_one));
  return from_angles(1 - below_one, sine, 2 * Pi * xi.y);
}

/// Of v, where a half vector about the normal is drawn with `power_direction`.
inline float half_power_density(const Vec3f& u, const Vec3f& v, float n) {
  return (n + 1) / (8 * Pi * cosine_of_half(u, v)) * glsl::CommonFormulas<float>().half_power(u, v, n);
}

}  // namespace reflectance
