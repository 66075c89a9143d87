// The models `phong` and `lewis` share the lobe (v . r_u)^n about the mirror direction, on the whole sphere.
#pragma once

#include <cmath>

#include "renderer/reflectance/geometry.h"
#include "renderer/reflectance/glsl_functions.h"

namespace reflectance::glsl {

template <class real>
struct CommonFormulas {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Samples a direction with pdf (n+1)/(2 pi) (v . r_u)^n; it may be below the horizon.
inline Vec3f cosine_lobe_direction(const Vec3f& u, float n, const Vec2f& xi) {
  return Frame(mirrored(u)).to_world(power_direction(n, xi));
}

/// Returns the solid-angle pdf of directions that the lobe samples.
inline float cosine_lobe_pdf(const Vec3f& u, const Vec3f& v, float n) {
  return (n + 1) / (2 * Pi) * glsl::CommonFormulas<float>().mirror_power(u, v, n);
}

}  // namespace reflectance
