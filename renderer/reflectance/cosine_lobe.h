// The lobe (v . r_u)^n about the mirror direction, on the whole sphere: what `phong` and `lewis` share.
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

/// A direction with density (n+1)/(2 pi) (v . r_u)^n; it may be under the horizon.
inline Vec3f cosine_lobe_direction(const Vec3f& u, float n, const Vec2f& xi) {
  // By way of 1 - cos, so that lobes of n = 1e6 keep their shape.
  const float below_one = -std::expm1(std::log1p(-xi.x) / (n + 1));
  const float sine = std::sqrt(below_one * (2 - below_one));
  return Frame(mirrored(u)).to_world(from_angles(1 - below_one, sine, 2 * Pi * xi.y));
}

inline float cosine_lobe_density(const Vec3f& u, const Vec3f& v, float n) {
  return (n + 1) / (2 * Pi) * glsl::CommonFormulas<float>().mirror_power(u, v, n);
}

}  // namespace reflectance
