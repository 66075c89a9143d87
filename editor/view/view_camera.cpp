#include "editor/view/view_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace editor {
namespace {

using grf::Vec3d;
using std::numbers::pi;

constexpr double Pole = pi / 2;

double pitch_of(const Vec3d& forward) { return std::asin(std::clamp(forward.y, -1.0, 1.0)); }

}  // namespace

ViewRay transformed(const ViewRay& ray, const grf::Matrix44d& matrix) {
  ViewRay result;
  result.nearest = ray.nearest;
  result.origin = ray.origin * matrix;
  matrix.multDirMatrix(ray.direction, result.direction);
  return result;
}

ViewCamera::ViewCamera(const transport::View& view) : target_(view.target) {
  const Vec3d forward = (view.target - view.eye).normalized();
  distance_ = (view.target - view.eye).length();
  field_of_view_ = view.field_of_view;
  pitch_ = pitch_of(forward);
  // Looking straight up or down, the up vector defines the heading.
  const Vec3d level = std::abs(forward.y) < 1 - 1e-9 ? forward : Vec3d(view.up) * (forward.y > 0 ? -1 : 1);
  yaw_ = std::atan2(-level.x, -level.z);
}

Vec3d ViewCamera::forward() const {
  return {-std::sin(yaw_) * std::cos(pitch_), std::sin(pitch_), -std::cos(yaw_) * std::cos(pitch_)};
}

Vec3d ViewCamera::right() const { return {std::cos(yaw_), 0, -std::sin(yaw_)}; }

Vec3d ViewCamera::up() const { return right().cross(forward()); }

transport::View ViewCamera::view() const {
  transport::View view;
  view.eye = eye();
  view.target = target_;
  view.up = std::abs(pitch_) < Pole - 1e-6 ? grf::Vec3f(0, 1, 0) : grf::Vec3f(up());
  view.field_of_view = static_cast<float>(field_of_view_);
  return view;
}

double ViewCamera::tangent() const { return std::tan(field_of_view_ * pi / 360); }

void ViewCamera::orbit(double to_the_right, double upwards) {
  yaw_ = std::remainder(yaw_ + to_the_right, 2 * pi);
  pitch_ = std::clamp(pitch_ - upwards, -Pole, Pole);
}

void ViewCamera::pan(double to_the_right, double upwards) {
  const double height = 2 * distance_ * tangent();
  target_ += (right() * to_the_right + up() * upwards) * height;
}

void ViewCamera::zoom(double factor, const grf::Vec2d& place, double aspect) {
  const double half_height = distance_ * tangent();
  const Vec3d fixed = target_ + right() * (place.x * half_height * aspect) + up() * (place.y * half_height);
  // At smaller distances the precision of a float mesh is exhausted.
  const double least = 1e-7 * std::max(1.0, target_.length()) / distance_;
  const double used = std::max(factor, least);
  target_ = fixed + (target_ - fixed) * used;
  distance_ *= used;
}

void ViewCamera::fly(double to_the_right, double upwards, double forwards) {
  target_ += right() * to_the_right + up() * upwards + forward() * forwards;
}

void ViewCamera::look(double to_the_right, double upwards) {
  const Vec3d fixed = eye();
  yaw_ = std::remainder(yaw_ - to_the_right, 2 * pi);
  pitch_ = std::clamp(pitch_ + upwards, -Pole, Pole);
  target_ = fixed + forward() * distance_;
}

void ViewCamera::set_target(const Vec3d& target) {
  // The distance along the view direction is unchanged, so that the eye only moves sideways.
  const double along = (target - eye()).dot(forward());
  if (along > 0) distance_ = along;
  target_ = target;
}

void ViewCamera::look_from(StandardView side) {
  yaw_ = side == StandardView::Right ? Pole : 0;
  pitch_ = side == StandardView::Top ? -Pole : 0;
}

void ViewCamera::look_from_opposite() {
  // Top and bottom views are opposite with the same right vector.
  if (std::abs(pitch_) < Pole - 1e-9) yaw_ = std::remainder(yaw_ + pi, 2 * pi);
  pitch_ = -pitch_;
}

void ViewCamera::frame(const grf::Box3d& box, double aspect) {
  if (box.isEmpty()) return;
  const double radius = std::max(box.size().length() / 2, 1e-6);
  const double narrow = tangent() * std::min(1.0, aspect);
  target_ = box.center();
  distance_ = is_orthographic_ ? radius / narrow : radius / std::sin(std::atan(narrow));
}

grf::Matrix44d ViewCamera::world_to_camera() const {
  const Vec3d x = right();
  const Vec3d y = up();
  const Vec3d z = -forward();
  const Vec3d from = eye();
  return {x.x, y.x, z.x, 0, x.y, y.y, z.y, 0, x.z, y.z, z.z, 0, -from.dot(x), -from.dot(y), -from.dot(z), 1};
}

grf::Matrix44d ViewCamera::camera_to_clip(double aspect, const grf::Box3d& box) const {
  const double radius = box.isEmpty() ? distance_ : std::max(box.size().length() / 2, 1e-3 * distance_);
  const double middle = box.isEmpty() ? distance_ : (box.center() - eye()).dot(forward());
  double far = middle + radius * 1.01;
  double near = middle - radius * 1.01;
  grf::Matrix44d clip;
  if (is_orthographic_) {
    const double half_height = distance_ * tangent();
    clip.setScale(Vec3d(1 / (half_height * aspect), 1 / half_height, -2 / (far - near)));
    clip[3][2] = -(far + near) / (far - near);
    return clip;
  }
  far = std::max(far, 1e-2 * distance_);
  near = std::max(near, std::min(1e-4 * far, 1e-2 * distance_));
  clip.setScale(Vec3d(1 / (tangent() * aspect), 1 / tangent(), -(far + near) / (far - near)));
  clip[2][3] = -1;
  clip[3][2] = -2 * far * near / (far - near);
  clip[3][3] = 0;
  return clip;
}

float ViewCamera::depth_offset(const grf::Matrix44d& camera_to_clip) {
  // A line is off its face by up to a pixel, about 1/1000 of the distance, and more where the face is steep.
  constexpr double Part = 4e-3;
  const bool is_perspective = camera_to_clip[2][3] != 0;
  // The depth is a + b / distance, where -b is this element.
  return static_cast<float>(is_perspective ? -camera_to_clip[3][2] * Part : Part);
}

ViewRay ViewCamera::ray(const grf::Vec2d& place, double aspect) const {
  const double t = tangent();
  const Vec3d aside = right() * (place.x * t * aspect) + up() * (place.y * t);
  ViewRay ray;
  if (is_orthographic_) {
    ray.origin = eye() + aside * distance_;
    ray.direction = forward();
    ray.nearest = -std::numeric_limits<double>::infinity();
  } else {
    ray.origin = eye();
    ray.direction = (forward() + aside).normalized();
  }
  return ray;
}

std::optional<grf::Vec2d> ViewCamera::place_of(const Vec3d& point, double aspect) const {
  const Vec3d from_eye = point - eye();
  const double depth = is_orthographic_ ? distance_ : from_eye.dot(forward());
  if (!(depth > 0)) return std::nullopt;
  const double half_height = depth * tangent();
  return grf::Vec2d(from_eye.dot(right()) / (half_height * aspect), from_eye.dot(up()) / half_height);
}

double ViewCamera::half_height_at(const Vec3d& point) const {
  return tangent() * (is_orthographic_ ? distance_ : std::abs((point - eye()).dot(forward())));
}

}  // namespace editor
