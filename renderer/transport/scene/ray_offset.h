#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "grf/math.h"

namespace transport {

using grf::Vec3f;

/// The relative error of a sum of three products in float: gamma_7 of Higham's bounds.
constexpr float InterpolationError = 7 * 0x1p-24F / (1 - 7 * 0x1p-24F);

inline Vec3f absolute(const Vec3f& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

/// The next float above or below a finite one, as std::nextafter, but inline.
inline float next_float(float value, bool up) {
  if (value == 0)
    return up ? std::numeric_limits<float>::denorm_min() : -std::numeric_limits<float>::denorm_min();
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return std::bit_cast<float>((value > 0) == up ? bits + 1 : bits - 1);
}

/// Offsets a point to the side of the surface that the direction points to: along the unit normal by the
/// bound of the position's error per axis, then rounded away from the surface (Pharr, Jakob and Humphreys
/// 2016, "Physically based rendering", section 3.9).
inline Vec3f offset_towards(const Vec3f& position, const Vec3f& error, const Vec3f& normal,
                            const Vec3f& direction) {
  const float distance = absolute(normal).dot(error);
  const Vec3f offset = normal * (direction.dot(normal) < 0 ? -distance : distance);
  const auto rounded_away = [](float value, float by) {
    if (by == 0) return value;
    return next_float(value + by, by > 0);
  };
  return {rounded_away(position.x, offset.x), rounded_away(position.y, offset.y),
          rounded_away(position.z, offset.z)};
}

}  // namespace transport
