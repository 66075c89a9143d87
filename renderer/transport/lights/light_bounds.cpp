#include "renderer/transport/lights/light_bounds.h"

#include <algorithm>
#include <cmath>

namespace transport {
namespace {

/// An angle in 0..pi, stored as cosine and sine: sums and differences need no inverse functions.
struct Angle {
  float cosine = 1;
  float sine = 0;

  static Angle of_cosine(float cosine) { return {cosine, std::sqrt(std::max(0.0F, 1 - cosine * cosine))}; }
};

/// Returns a - b, or 0 if b is larger.
Angle difference(const Angle& a, const Angle& b) {
  if (a.cosine >= b.cosine) return {};
  return {a.cosine * b.cosine + a.sine * b.sine, a.sine * b.cosine - a.cosine * b.sine};
}

float angle_between(const Vec3f& a, const Vec3f& b) {
  // By chord lengths: an arc cosine is inaccurate near 0.
  return 2 * std::atan2((a - b).length(), (a + b).length());
}

}  // namespace

Cone merged(const Cone& a, const Cone& b) {
  const Cone& wide = a.cosine <= b.cosine ? a : b;
  const Cone& narrow = a.cosine <= b.cosine ? b : a;
  if (wide.axis == narrow.axis) return wide;
  const float wide_angle = std::acos(std::clamp(wide.cosine, -1.0F, 1.0F));
  const float narrow_angle = std::acos(std::clamp(narrow.cosine, -1.0F, 1.0F));
  const float between = angle_between(wide.axis, narrow.axis);
  if (between + narrow_angle <= wide_angle) return wide;
  const float angle = (wide_angle + between + narrow_angle) / 2;
  const Vec3f across = narrow.axis - wide.axis * wide.axis.dot(narrow.axis);
  const float length = across.length();
  if (between < 1e-6F) return {wide.axis, std::max(-1.0F, wide.cosine - 1e-5F)};
  if (angle >= reflectance::Pi || !(length > 1e-6F)) return {wide.axis, -1};
  const float turn = angle - wide_angle;
  const Vec3f axis = wide.axis * std::cos(turn) + across * (std::sin(turn) / length);
  return {axis.normalized(), std::max(-1.0F, std::cos(angle) - 1e-6F)};
}

LightBounds bounds_of(const Emitter& emitter) {
  LightBounds bounds;
  const Vec3f& a = emitter.edge1;
  const Vec3f& b = emitter.edge2;
  float radius2 = 0;
  if (emitter.is_triangle) {
    const Vec3f centre = (a + b) / 3;
    bounds.centre = emitter.corner + centre;
    radius2 = std::max({centre.length2(), (a - centre).length2(), (b - centre).length2()});
  } else {
    bounds.centre = emitter.corner + (a + b) / 2;
    radius2 = std::max((a + b).length2(), (a - b).length2()) / 4;
  }
  bounds.radius = std::sqrt(radius2);
  const Vec3f normal = emitter.doubled_area_normal();
  const float length = normal.length();
  if (length > 0) bounds.normals.axis = normal / length;
  bounds.power = (emitter.is_triangle ? length / 2 : length) * reflectance::mean(emitter.radiance);
  return bounds;
}

float importance(const LightBounds& bounds, const Vec3f& from, const Vec3f& normal) {
  const Vec3f to_centre = bounds.centre - from;
  const float distance2 = to_centre.length2();
  const float radius2 = bounds.radius * bounds.radius;
  if (distance2 <= radius2) return radius2 > 0 ? bounds.power / std::max(distance2, radius2 / 4) : 0;
  const Vec3f direction = to_centre / std::sqrt(distance2);
  // The half-angle that the sphere subtends at the point.
  const float sine2 = radius2 / distance2;
  const Angle spread{std::sqrt(1 - sine2), std::sqrt(sine2)};
  const Angle received = difference(Angle::of_cosine(direction.dot(normal)), spread);
  if (received.cosine <= 0) return 0;
  const Angle off_axis = Angle::of_cosine(-direction.dot(bounds.normals.axis));
  const Angle emitted = difference(difference(off_axis, Angle::of_cosine(bounds.normals.cosine)), spread);
  if (emitted.cosine <= 0) return 0;
  return bounds.power * received.cosine * emitted.cosine / distance2;
}

bool can_illuminate(const Emitter& emitter, const Vec3f& from, const Vec3f& normal) {
  const Vec3f to_corner = emitter.corner - from;
  if (emitter.doubled_area_normal().dot(to_corner) >= 0) return false;
  const float corner = to_corner.dot(normal);
  const float along1 = emitter.edge1.dot(normal);
  const float along2 = emitter.edge2.dot(normal);
  const float highest = emitter.is_triangle ? std::max({0.0F, along1, along2})
                                            : std::max(0.0F, along1) + std::max(0.0F, along2);
  return corner + highest > 0;
}

float importance(const Emitter& emitter, const Vec3f& from, const Vec3f& normal) {
  return can_illuminate(emitter, from, normal) ? importance(bounds_of(emitter), from, normal) : 0;
}

}  // namespace transport
