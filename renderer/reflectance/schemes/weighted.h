#pragma once

#include <cmath>
#include <optional>

#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// Returns a sample for a direction with its pdf, of weight f cos / pdf, or nothing if it contributes
/// nothing. For schemes without a closed form of the weight.
inline std::optional<DirectionSample> weighted(const Brdf& brdf, const Vec3f& u, const Vec3f& v, float pdf) {
  if (u.z <= 0 || v.z <= 0 || !(pdf > 0) || !std::isfinite(pdf)) return std::nullopt;
  return DirectionSample{v, evaluate(brdf, u, v) * (v.z / pdf), pdf};
}

}  // namespace reflectance
