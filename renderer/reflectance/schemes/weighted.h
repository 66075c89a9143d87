#pragma once

#include <cmath>
#include <optional>

#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// A direction that was drawn with that density, with its weight f cos / density; nothing where it carries
/// nothing. For schemes that know no closed form of the weight.
inline std::optional<DirectionSample> weighted(const Brdf& brdf, const Vec3f& u, const Vec3f& v,
                                               float density) {
  if (u.z <= 0 || v.z <= 0 || !(density > 0) || !std::isfinite(density)) return std::nullopt;
  return DirectionSample{v, evaluate(brdf, u, v) * (v.z / density), density};
}

}  // namespace reflectance
