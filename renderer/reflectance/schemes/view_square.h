// Directions are tabulated for a view over a square. Lambert's azimuthal equal-area projection maps the
// hemisphere to a disc, and Shirley and Chiu's map (1997) the disc to a square. Directions are relative to
// the view's azimuth, and the square is cut into columns at the mirror direction, the normal and the view
// itself, so that all three stay in place for every view, and a table can be blended with the next view's
// without doubling a lobe.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "renderer/reflectance/geometry.h"
#include "renderer/reflectance/schemes/lanes.h"

namespace reflectance {

/// Returns the distance of a direction from the square's centre, from 0 at the normal to 1 at the horizon.
inline float square_radius(const Vec3f& v) {
  // 1 - z is computed from the sine, which is accurate near the normal.
  return std::sqrt((v.x * v.x + v.y * v.y) / (1 + v.z));
}

inline Vec3f direction_at(float radius, float phi) {
  return from_angles((1 - radius) * (1 + radius), radius * std::sqrt(2 - radius * radius), phi);
}

/// Returns sine and cosine of an angle from -pi/4 to pi/4, within 3e-8, faster than the library functions.
inline Vec2f sine_and_cosine(float angle) {
  const float x = angle * angle;
  const float sine = 1 + x * (-1.0F / 6 + x * (1.0F / 120 + x * (-1.0F / 5040 + x * (1.0F / 362880))));
  const float cosine = 1 + x * (-1.0F / 2 + x * (1.0F / 24 + x * (-1.0F / 720 + x * (1.0F / 40320))));
  return {angle * sine, cosine};
}

/// Returns atan of a tangent from 0 to 1, within 1e-7 (Abramowitz and Stegun 1964, 4.4.49).
inline float angle_of_tangent(float tangent) {
  const float x = tangent * tangent;
  const float x2 = x * x;
  const float low = (1 - 0.3333314528F * x) + x2 * (0.1999355085F - 0.1420889944F * x);
  const float high = (0.1065626393F - 0.0752896400F * x) + x2 * (0.0429096138F - 0.0161657367F * x);
  return tangent * (low + x2 * x2 * (high + x2 * x2 * 0.0028662257F));
}

/// Maps a point of [-1,1]^2 to a direction.
inline Vec3f from_square(float a, float b) {
  const float width = std::abs(a);
  const float height = std::abs(b);
  const float radius = if_greater(width, height, a, b);
  const float other = if_greater(width, height, b, a);
  const Vec2f turn = sine_and_cosine(radius != 0 ? Pi / 4 * (other / radius) : 0.0F);
  const float length = radius * std::sqrt(2 - radius * radius);
  const float along = length * turn.y;
  const float across = length * turn.x;
  return {if_greater(width, height, along, across), if_greater(width, height, across, along),
          (1 - radius) * (1 + radius)};
}

/// Returns the azimuth of a point of the plane, from -pi to pi.
inline float angle_of(float x, float y) {
  const float width = std::abs(x);
  const float height = std::abs(y);
  const float longer = std::max(width, height);
  const float octant = longer > 0 ? angle_of_tangent(std::min(width, height) / longer) : 0.0F;
  const float quadrant = Pi / 4 + std::copysign(Pi / 4 - octant, height - width);
  return std::copysign(Pi / 2 - std::copysign(Pi / 2 - quadrant, x), y);
}

inline Vec2f to_square(const Vec3f& v) {
  const float x = std::abs(v.x);
  const float y = std::abs(v.y);
  const float larger = std::max(x, y);
  if (!(larger > 0)) return {0, 0};
  const float radius = square_radius(v);
  const float other = radius * (4 / Pi) * angle_of_tangent(std::min(x, y) / larger);
  return {std::copysign(x >= y ? radius : other, v.x), std::copysign(x >= y ? other : radius, v.y)};
}

/// A point in one of the four columns, each of which is a unit square.
struct ColumnPoint {
  std::size_t column = 0;
  Vec2f local;
};

/// The columns for a view whose radius in the square is given. If only the half with y > 0 is tabulated, a
/// column is [0,1] high, else [-1,1].
class ViewColumns {
 public:
  ViewColumns(float view_radius, bool is_half) : radius_(view_radius), is_half_(is_half) {}

  std::array<float, 4> widths() const { return {1 - radius_, radius_, radius_, 1 - radius_}; }

  Vec3f direction(const ColumnPoint& point) const {
    const float x = edges()[point.column] + widths()[point.column] * point.local.x;
    return from_square(x, is_half_ ? point.local.y : 2 * point.local.y - 1);
  }

  ColumnPoint point(const Vec3f& v) const {
    const Vec2f square = to_square(v);
    const bool is_outer = std::abs(square.x) >= radius_;
    const std::size_t column = square.x < 0 ? (is_outer ? 0 : 1) : (is_outer ? 3 : 2);
    const float width = widths()[column];
    const float x = width > 0 ? (square.x - edges()[column]) / width : 0;
    const float y = is_half_ ? std::abs(square.y) : (square.y + 1) / 2;
    return {column, {std::clamp(x, 0.0F, 1.0F), y}};
  }

 private:
  std::array<float, 4> edges() const { return {-1, -radius_, 0, radius_}; }

  float radius_;
  bool is_half_;
};

}  // namespace reflectance
