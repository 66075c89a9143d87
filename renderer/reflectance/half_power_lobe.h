// The model `blinn` and the samplers that draw half vectors with a power share the lobe (n . h)^n of the half
// vector.
#pragma once

#include "renderer/reflectance/cosine_lobe.h"
#include "renderer/reflectance/geometry.h"

namespace reflectance {

/// Returns the solid-angle pdf of v for a half vector about the normal sampled by `power_direction`.
inline float half_power_pdf(const Vec3f& u, const Vec3f& v, float n) {
  return (n + 1) / (8 * Pi * cosine_of_half(u, v)) * glsl::CommonFormulas<float>().half_power(u, v, n);
}

}  // namespace reflectance
