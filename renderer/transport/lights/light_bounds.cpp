#include "renderer/transport/lights/light_bounds.h"

#include <algorithm>
#include <cmath>

#include "renderer/transport/scene/ray_offset.h"

namespace transport {
namespace {

/// Eight angles in 0..pi, stored as cosine and sine: sums and differences need no inverse functions.
struct Angles {
  Float8 cosine;
  Float8 sine;

  static Angles of_cosine(const Float8& cosine) {
    return {cosine, square_root(larger(1 - cosine * cosine, 0))};
  }
};

/// Returns a - b, or 0 if b is larger.
Angles difference(const Angles& a, const Angles& b) {
  const auto is_less = a.cosine < b.cosine;
  return {select(is_less, a.cosine * b.cosine + a.sine * b.sine, 1),
          select(is_less, a.sine * b.cosine - a.cosine * b.sine, 0)};
}

Float8 load(const std::array<float, Float8::size()>& lanes) {
  return {lanes.data(), std::experimental::vector_aligned};
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
  bounds.box.extendBy(emitter.corner);
  bounds.box.extendBy(emitter.corner + emitter.edge1);
  bounds.box.extendBy(emitter.corner + emitter.edge2);
  if (!emitter.is_triangle) bounds.box.extendBy(emitter.corner + emitter.edge1 + emitter.edge2);
  bounds.normals.axis = emitter.doubled_area_normal().normalized();
  bounds.power = emitter.power();
  return bounds;
}

void LightBounds8::Vectors::set(int index, const Vec3f& value) {
  x[index] = value.x;
  y[index] = value.y;
  z[index] = value.z;
}

void LightBounds8::set(int index, const LightBounds& bounds) {
  const Vec3f centre = bounds.box.center();
  // Slightly enlarged, for rounding.
  const Vec3f half_size = (bounds.box.max - centre) * (1 + 1e-6F);
  centre_.set(index, centre);
  half_size_.set(index, half_size);
  axis_.set(index, bounds.normals.axis);
  cosine_[index] = bounds.normals.cosine;
  power_[index] = bounds.power;
}

Float8 LightBounds8::importance(const Vec3f& from, const Vec3f& normal) const {
  const Float8 x = load(centre_.x) - from.x;
  const Float8 y = load(centre_.y) - from.y;
  const Float8 z = load(centre_.z) - from.z;
  const Float8 height = x * normal.x + y * normal.y + z * normal.z;
  const Float8 half_x = load(half_size_.x);
  const Float8 half_y = load(half_size_.y);
  const Float8 half_z = load(half_size_.z);
  const Vec3f up = absolute(normal);
  const Float8 above = height + half_x * up.x + half_y * up.y + half_z * up.z;
  const Float8 axis_x = load(axis_.x);
  const Float8 axis_y = load(axis_.y);
  const Float8 axis_z = load(axis_.z);
  const Float8 behind = x * axis_x + y * axis_y + z * axis_z;
  // Points further behind the centre than the box extends along a common normal see no front.
  const Float8 cosine = load(cosine_);
  const Float8 depth = magnitude(axis_x) * half_x + magnitude(axis_y) * half_y + magnitude(axis_z) * half_z;
  const auto is_seen = above > 0 && (cosine < 1 || behind < depth) && load(power_) > 0;
  if (none_of(is_seen)) return 0;

  const Float8 distance2 = x * x + y * y + z * z;
  const Float8 radius2 = half_x * half_x + half_y * half_y + half_z * half_z;
  const Float8 per_distance = 1 / square_root(distance2);
  // The half-angle that the sphere subtends at the point.
  const Float8 sine = square_root(radius2) * per_distance;
  const Angles spread{square_root(larger(1 - sine * sine, 0)), sine};
  const Angles received = difference(Angles::of_cosine(height * per_distance), spread);
  const Angles off_axis = Angles::of_cosine(-behind * per_distance);
  const Angles emitted = difference(difference(off_axis, Angles::of_cosine(cosine)), spread);
  const Float8 outside = larger(received.cosine, 0) * larger(emitted.cosine, 0);
  const Float8 cosines = select(distance2 <= radius2, 1, outside);
  const Float8 clamped2 = larger(distance2, radius2 / 4);
  return select(is_seen && clamped2 > 0, load(power_) * cosines / clamped2, 0);
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

}  // namespace transport
