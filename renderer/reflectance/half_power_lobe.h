// The lobe (n . h)^n about the half vector: what `blinn` and all that draw half vectors with a power share.
#pragma once

#include "renderer/reflectance/cosine_lobe.h"
#include "renderer/reflectance/geometry.h"

namespace reflectance {

/// Of v, where a half vector about the normal is drawn with `power_direction`.
inline float half_power_density(const Vec3f& u, const Vec3f& v, float n) {
  return (n + 1) / (8 * Pi * cosine_of_half(u, v)) * glsl::CommonFormulas<float>().half_power(u, v, n);
}

}  // namespace reflectance
