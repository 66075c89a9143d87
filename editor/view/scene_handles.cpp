#include "editor/view/scene_handles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "editor/view/screen_geometry.h"

namespace editor {
namespace {

using grf::Vec2d;
using grf::Vec3d;

/// Logical pixels.
constexpr double GripRadius = 10;
constexpr double LineRadius = 5;

constexpr std::array<Vec3d, 3> Axes = {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};

SceneHandle light_handle(const LightObject& object) {
  const auto [a, b, c, d] = corners_of(object);
  const Vec3d middle = (a + c) / 2;
  const double side = object.to_world.determinant() < 0 ? -1 : 1;
  const Vec3d normal = (b - a).cross(d - a).normalized() * side;
  const double length = std::sqrt((b - a).cross(d - a).length()) / 2;
  const Vec3d tip = middle + normal * length;
  const Vec3d aside = (b - a).normalized() * (length / 6);
  SceneHandle handle{{HandleKind::Light, object.path, 0}, "Light", a, middle, {}};
  handle.lines = {{a, b}, {b, c}, {c, d}, {d, a}, {a, c}, {b, d}, {middle, tip}};
  handle.lines.emplace_back(tip, tip - normal * (length / 4) + aside);
  handle.lines.emplace_back(tip, tip - normal * (length / 4) - aside);
  return handle;
}

SceneHandle observer_handle(const ObserverObject& observer, double size) {
  SceneHandle handle{{HandleKind::Observer, observer.path, observer.number},
                     "Observer",
                     observer.position,
                     observer.position,
                     {}};
  // An upright eye with its pupil.
  constexpr int Steps = 24;
  const auto ring = [&](double width, double height) {
    const auto at = [&](int i) {
      const double angle = 2 * std::numbers::pi * i / Steps;
      return observer.position + Vec3d(std::cos(angle) * width, std::sin(angle) * height, 0);
    };
    for (int i = 0; i < Steps; ++i) handle.lines.emplace_back(at(i), at(i + 1));
  };
  ring(size, size / 2);
  ring(size / 4, size / 4);
  return handle;
}

void add_camera(const transport::View& view, double aspect, double size, std::vector<SceneHandle>& handles) {
  const ViewCamera camera(view);
  const double half = std::tan(view.field_of_view * std::numbers::pi / 360) * 2 * size;
  const Vec3d middle = view.eye + camera.forward() * (2 * size);
  const auto corner = [&](double x, double y) {
    return middle + camera.right() * (x * half * aspect) + camera.up() * (y * half);
  };
  const std::array<Vec3d, 4> corners = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
  SceneHandle eye_handle{{HandleKind::CameraEye, {}, 0}, "Render camera", view.eye, view.eye, {}};
  for (std::size_t i = 0; i < 4; ++i) {
    eye_handle.lines.emplace_back(view.eye, corners[i]);
    eye_handle.lines.emplace_back(corners[i], corners[(i + 1) % 4]);
  }
  // The up direction.
  eye_handle.lines.emplace_back(corner(-0.5, 1.15), corner(0, 1.7));
  eye_handle.lines.emplace_back(corner(0, 1.7), corner(0.5, 1.15));
  eye_handle.lines.emplace_back(corner(0.5, 1.15), corner(-0.5, 1.15));
  SceneHandle target{
      {HandleKind::CameraTarget, {}, 0}, "Render camera's target", view.target, view.target, {}};
  for (const Vec3d& axis : Axes) {
    target.lines.emplace_back(view.target - axis * size / 2, view.target + axis * size / 2);
  }
  handles.push_back(std::move(eye_handle));
  handles.push_back(std::move(target));
}

/// The distance from a pixel to a handle, or infinity if it is too far.
double nearness(const SceneHandle& handle, const ViewCamera& camera, const Vec2d& pixel, const Vec2d& size) {
  const auto grip = pixel_of(handle.grip, camera, size);
  if (grip && (*grip - pixel).length() <= GripRadius) return (*grip - pixel).length() / 2;
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : handle.lines) {
    const auto a = pixel_of(from, camera, size);
    const auto b = pixel_of(to, camera, size);
    if (a && b) nearest = std::min(nearest, distance_to_line(pixel, *a, *b));
  }
  return nearest <= LineRadius ? nearest + GripRadius : std::numeric_limits<double>::infinity();
}

/// A handle translated by an offset.
SceneHandle moved(const SceneHandle& handle, const Vec3d& offset) {
  SceneHandle result = handle;
  result.position += offset;
  result.grip += offset;
  for (auto& [from, to] : result.lines) {
    from += offset;
    to += offset;
  }
  return result;
}

/// The new position of a handle's grip when the pointer moves from one pixel to another.
Vec3d dragged(const Vec3d& grip, const ViewCamera& camera, const Vec2d& from, const Vec2d& to,
              const Vec2d& size, bool along_axis) {
  const double pixel = 2 * camera.half_height_at(grip) / size.y;
  const Vec2d way = to - from;
  if (!along_axis) return grip + (camera.right() * way.x - camera.up() * way.y) * pixel;
  // The projection of one world unit along each axis.
  Vec3d best = grip;
  double best_cosine = -1;
  for (const Vec3d& axis : Axes) {
    const Vec2d on_screen(axis.dot(camera.right()) / pixel, -axis.dot(camera.up()) / pixel);
    const double length = on_screen.length();
    if (length * pixel < 0.05 || way.length() == 0) continue;  // it points towards the eye
    const double cosine = std::abs(on_screen.dot(way)) / (length * way.length());
    if (cosine <= best_cosine) continue;
    best_cosine = cosine;
    best = grip + axis * (on_screen.dot(way) / (length * length));
  }
  return best;
}

}  // namespace

std::vector<SceneHandle> handles_of(const SceneObjects& objects, const std::optional<transport::View>& camera,
                                    double aspect, double size) {
  std::vector<SceneHandle> handles;
  for (const LightObject& light : objects.lights) handles.push_back(light_handle(light));
  for (const ObserverObject& observer : objects.observers) handles.push_back(observer_handle(observer, size));
  if (camera) add_camera(*camera, aspect, size, handles);
  return handles;
}

SceneHandle HandleGesture::shown(std::size_t number) const {
  return taken_ == number ? moved(handles_[number], offset_) : handles_[number];
}

const SceneHandle* HandleGesture::at(const Vec2d& pixel, const ViewCamera& camera, const Vec2d& size) const {
  const SceneHandle* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const SceneHandle& handle : handles_) {
    const double distance = nearness(handle, camera, pixel, size);
    if (distance >= least) continue;
    least = distance;
    nearest = &handle;
  }
  return nearest;
}

bool HandleGesture::hover(const SceneHandle* handle) {
  const std::optional<HandleId> id = handle != nullptr ? std::optional(handle->id) : std::nullopt;
  return std::exchange(hovered_, id) != id;
}

void HandleGesture::begin(const SceneHandle& handle, const Vec2d& pixel) {
  taken_ = static_cast<std::size_t>(&handle - handles_.data());
  taken_at_ = pixel;
  offset_ = Vec3d(0);
}

void HandleGesture::drag(const Vec2d& pixel, const ViewCamera& camera, const Vec2d& size, bool along_axis) {
  const Vec3d& grip = handles_[*taken_].grip;
  offset_ = dragged(grip, camera, taken_at_, pixel, size, along_axis) - grip;
}

SceneHandle HandleGesture::end(bool stays) {
  SceneHandle& handle = handles_[*taken_];
  if (stays) handle = moved(handle, offset_);
  taken_.reset();
  return handle;
}

}  // namespace editor
