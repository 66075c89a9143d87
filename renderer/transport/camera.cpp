#include "renderer/transport/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grf/framing.h"
#include "renderer/reflectance/geometry.h"
#include "renderer/transport/scene/compiled_scene.h"

namespace transport {
namespace {

float half_height(float field_of_view) { return std::tan(field_of_view * std::numbers::pi_v<float> / 360); }

Vec3f rightwards(const Vec3f& forward, const Vec3f& up) {
  for (const Vec3f& candidate : {up, Vec3f(0, 0, 1), Vec3f(1, 0, 0)}) {
    const Vec3f right = forward.cross(candidate);
    if (right.length2() > 1e-10F * candidate.length2()) return right.normalized();
  }
  return {1, 0, 0};
}

}  // namespace

View view_of(const grf::Box3d& bounds, float field_of_view, float aspect) {
  View view;
  view.field_of_view = field_of_view;
  view.eye = grf::framing_eye(bounds, double(field_of_view), double(aspect));
  if (!bounds.isEmpty()) view.target = bounds.center();
  return view;
}

float focus_distance_of(const View& view) {
  return view.focus_distance > 0 ? view.focus_distance
                                 : static_cast<float>((view.target - view.eye).length());
}

View relative_to(const grf::Vec3d& origin, const View& view) {
  View result = view;
  result.eye -= origin;
  result.target -= origin;
  return result;
}

Camera::Camera(const View& view, int width, int height)
    : eye_(view.eye),
      width_(static_cast<float>(width)),
      height_(static_cast<float>(height)),
      focus_distance_(focus_distance_of(view)) {
  const Vec3f forward((view.target - view.eye).normalized());
  const Vec3f right = rightwards(forward, view.up);
  const Vec3f up = right.cross(forward);
  const float size = 2 * half_height(view.field_of_view) / static_cast<float>(height);
  step_x_ = right * size;
  step_y_ = up * -size;
  pixel_angle_ = size;
  lens_x_ = right * view.lens_radius;
  lens_y_ = up * view.lens_radius;
  corner_ = forward - step_x_ * (static_cast<float>(width) / 2) - step_y_ * (static_cast<float>(height) / 2);
}

Imath::M44f Camera::world_to_camera() const {
  const Vec3f right = step_x_.normalized();
  const Vec3f up = -step_y_.normalized();
  const Vec3f back = right.cross(up);
  const Imath::M44f turn(right.x, up.x, back.x, 0, right.y, up.y, back.y, 0, right.z, up.z, back.z, 0, 0, 0,
                         0, 1);
  return Imath::M44f().setTranslation(-eye_) * turn;
}

Imath::M44f Camera::world_to_image() const {
  const float scale_x = 1 / (step_x_.length() * width_);
  const float scale_y = 1 / (step_y_.length() * height_);
  // w is the distance along the view, -z.
  const Imath::M44f project(scale_x, 0, 0, 0, 0, -scale_y, 0, 0, -0.5F, -0.5F, 1, -1, 0, 0, 0, 0);
  return world_to_camera() * project;
}

Ray Camera::ray(float x, float y) const {
  return {eye_, (corner_ + step_x_ * x + step_y_ * y).normalized(), {}, {0, pixel_angle_}};
}

Ray Camera::ray(float x, float y, const grf::Vec2f& xi) const {
  if (!has_lens()) return ray(x, y);
  const grf::Vec2f on_disc = reflectance::to_disc(xi);
  const Vec3f from = lens_x_ * on_disc.x + lens_y_ * on_disc.y;
  const Vec3f to = (corner_ + step_x_ * x + step_y_ * y) * focus_distance_;
  return {eye_ + from, (to - from).normalized(), {}, {0, pixel_angle_}};
}

Camera camera_of(const CompiledScene& scene, const View& view, int width, int height) {
  View local = relative_to(scene.origin(), view);
  const grf::Vec3d eye = scene.off_faces(local.eye, local.target - local.eye);
  local.target += eye - local.eye;
  local.eye = eye;
  return Camera(local, width, height);
}

}  // namespace transport
