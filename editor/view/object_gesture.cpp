#include "editor/view/object_gesture.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "editor/document/scene_places.h"
#include "editor/view/screen_geometry.h"

namespace editor {
namespace {

using grf::Vec2d;
using grf::Vec3d;
using Constraint = AxisConstraint::Kind;
using Kind = ObjectGesture::Kind;

/// Logical pixels.
constexpr double GizmoLength = 90;
constexpr double PickRadius = 7;
/// An axis that points at the eye more than this is no direction in the image.
constexpr double FacingCosine = 0.98;

/// Builds the lines of a gizmo from points in units of its length.
class GizmoShape {
 public:
  GizmoShape(const GizmoTarget& target, const std::array<Vec3d, 3>& axes, const GizmoWindow& window)
      : target_(target), axes_(axes), window_(window) {
    length_ = GizmoLength * 2 * window.camera.half_height_at(target.pivot) / window.size.y;
  }

  void add_moves() {
    for (int axis = 0; axis < 3; ++axis) {
      if (!faces_eye(axis)) add_arrow(axis);
      add_plane(axis);
    }
    add_screen_square(9);
  }

  void add_rotations() {
    for (int axis = 0; axis < 3; ++axis) add_ring(axis);
    const Vec3d right = window_.camera.right();
    const Vec3d up = window_.camera.up();
    add_circle(right * 1.15, up * 1.15, {Constraint::Free, 0}, false);
  }

  void add_scales() {
    for (int axis = 0; axis < 3; ++axis) {
      if (faces_eye(axis)) continue;
      const AxisConstraint part{Constraint::Axis, axis};
      const Vec3d along = direction(axis);
      add(along * 0.15, along * 0.92, part);
      const Vec3d across = direction((axis + 1) % 3) * 0.06;
      const Vec3d other = direction((axis + 2) % 3) * 0.06;
      for (const double end : {0.92, 1.04}) {
        add_loop({along * end + across + other, along * end + across - other, along * end - across - other,
                  along * end - across + other},
                 part);
      }
      for (const double side : {-1.0, 1.0}) {
        add(along * 0.92 + across * side + other, along * 1.04 + across * side + other, part);
        add(along * 0.92 + across * side - other, along * 1.04 + across * side - other, part);
      }
    }
    add_screen_square(9);
  }

  /// A long line along an axis of a running gesture.
  void add_guide(int axis, const AxisConstraint& part) {
    add(direction(axis) * -12, direction(axis) * 12, part);
  }

  std::vector<ObjectGesture::Line> take() { return std::move(lines_); }

 private:
  const Vec3d& direction(int axis) const { return axes_[static_cast<std::size_t>(axis)]; }

  bool faces_eye(int axis) const {
    const Vec3d to_pivot = (target_.pivot - window_.camera.eye()).normalized();
    const Vec3d view = window_.camera.is_orthographic() ? window_.camera.forward() : to_pivot;
    return std::abs(direction(axis).dot(view)) > FacingCosine;
  }

  void add(const Vec3d& from, const Vec3d& to, const AxisConstraint& part) {
    const auto a = pixel_of(target_.pivot + from * length_, window_.camera, window_.size);
    const auto b = pixel_of(target_.pivot + to * length_, window_.camera, window_.size);
    if (a && b) lines_.push_back({*a, *b, part});
  }

  void add_loop(const std::array<Vec3d, 4>& corners, const AxisConstraint& part) {
    for (std::size_t i = 0; i < 4; ++i) add(corners[i], corners[(i + 1) % 4], part);
  }

  void add_arrow(int axis) {
    const AxisConstraint part{Constraint::Axis, axis};
    const Vec3d along = direction(axis);
    add(along * 0.15, along, part);
    for (const int side : {1, 2}) {
      const Vec3d across = direction((axis + side) % 3) * 0.06;
      add(along, along * 0.85 + across, part);
      add(along, along * 0.85 - across, part);
    }
  }

  void add_plane(int axis) {
    const Vec3d a = direction((axis + 1) % 3);
    const Vec3d b = direction((axis + 2) % 3);
    add_loop({a * 0.3 + b * 0.3, a * 0.45 + b * 0.3, a * 0.45 + b * 0.45, a * 0.3 + b * 0.45},
             {Constraint::Plane, axis});
  }

  void add_ring(int axis) {
    add_circle(direction((axis + 1) % 3), direction((axis + 2) % 3), {Constraint::Axis, axis}, true);
  }

  void add_circle(const Vec3d& a, const Vec3d& b, const AxisConstraint& part, bool hides_back) {
    constexpr int Steps = 64;
    const auto at = [&](int i) {
      const double angle = 2 * std::numbers::pi * i / Steps;
      return a * std::cos(angle) + b * std::sin(angle);
    };
    const bool is_seen_flat = std::abs(a.cross(b).normalized().dot(window_.camera.forward())) > FacingCosine;
    for (int i = 0; i < Steps; ++i) {
      const bool is_behind = (at(i) + at(i + 1)).dot(window_.camera.forward()) > 0.02;
      if (!hides_back || is_seen_flat || !is_behind) add(at(i), at(i + 1), part);
    }
  }

  void add_screen_square(double half) {
    const auto middle = pixel_of(target_.pivot, window_.camera, window_.size);
    if (!middle) return;
    const std::array<Vec2d, 4> corners = {Vec2d(-half, -half), Vec2d(half, -half), Vec2d(half, half),
                                          Vec2d(-half, half)};
    for (std::size_t i = 0; i < 4; ++i)
      lines_.push_back({*middle + corners[i], *middle + corners[(i + 1) % 4], {Constraint::Free, 0}});
  }

  const GizmoTarget& target_;
  const std::array<Vec3d, 3>& axes_;
  const GizmoWindow& window_;
  double length_ = 1;
  std::vector<ObjectGesture::Line> lines_;
};

/// The parameter of the point of a line that is nearest to a ray; nothing if they are nearly parallel.
std::optional<double> nearest_on_line(const Vec3d& point, const Vec3d& direction, const ViewRay& ray) {
  const Vec3d to_point = point - ray.origin;
  const double length2 = ray.direction.length2();
  const double cosine = ray.direction.dot(direction);
  const double divisor = length2 - cosine * cosine;
  if (divisor < 1e-6 * length2) return std::nullopt;
  return (to_point.dot(ray.direction) * cosine - to_point.dot(direction) * length2) / divisor;
}

double rounded_to(double number, double step) { return std::round(number / step) * step; }

/// Rounds to a multiple of a power of ten, as the decimal that it is.
double rounded_to_decimals(double number, int exponent) {
  return std::stod(
      fmt::format("{:.{}f}", rounded_to(number, std::pow(10, exponent)), std::max(0, -exponent)));
}

double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

}  // namespace

void ObjectGesture::set_target(std::optional<GizmoTarget> target) {
  target_ = std::move(target);
  hovered_.reset();
  cancel();
}

std::array<Vec3d, 3> ObjectGesture::axes(bool is_local) const {
  std::array<Vec3d, 3> result = {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
  if (!is_local) return result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto* row = target_->local_axes[axis];
    result[static_cast<std::size_t>(axis)] = Vec3d(row[0], row[1], row[2]);
  }
  return result;
}

std::vector<ObjectGesture::Line> ObjectGesture::lines(const GizmoWindow& window) const {
  if (!target_ || (!tool_ && !running_)) return {};
  const auto directions = axes(running_ ? running_->is_local : target_->is_local);
  GizmoShape shape(*target_, directions, window);
  if (running_) {
    const AxisConstraint& constraint = running_->constraint;
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_shown = constraint.kind != Constraint::Free &&
                            (constraint.kind == Constraint::Axis) == (axis == constraint.axis);
      if (is_shown) shape.add_guide(axis, {Constraint::Axis, axis});
    }
    return shape.take();
  }
  if (*tool_ == Kind::Translation) shape.add_moves();
  if (*tool_ == Kind::Rotation) shape.add_rotations();
  if (*tool_ == Kind::Scale) shape.add_scales();
  std::vector<Line> result = shape.take();
  for (Line& line : result) line.is_lit = hovered_ == line.constraint;
  return result;
}

std::optional<AxisConstraint> ObjectGesture::part_at(const Vec2d& pixel, const GizmoWindow& window) const {
  if (running_) return std::nullopt;
  std::optional<AxisConstraint> nearest;
  double least = PickRadius;
  for (const Line& line : lines(window)) {
    const double distance = distance_to_line(pixel, line.from, line.to);
    if (distance >= least) continue;
    least = distance;
    nearest = line.constraint;
  }
  return nearest;
}

bool ObjectGesture::hover(const std::optional<AxisConstraint>& part) {
  return std::exchange(hovered_, part) != part;
}

void ObjectGesture::begin(Kind kind, const AxisConstraint& constraint, const Vec2d& pixel,
                          const GizmoWindow& window) {
  hovered_.reset();
  if (!target_) return;
  running_ = Running{kind, constraint, target_->is_local, pixel, pixel, Vec3d(0), 0, 0, 0, Vec3d(0), 1, {}};
  restart(window);
}

/// Begins to follow the pointer anew, under another constraint.
void ObjectGesture::restart(const GizmoWindow& window) {
  const Vec3d to_eye = window.camera.eye() - target_->pivot;
  running_->towards_eye = window.camera.is_orthographic() ? -window.camera.forward() : to_eye.normalized();
  running_->offset = Vec3d(0);
  running_->degrees = running_->raw_degrees = 0;
  running_->factor = 1;
  running_->last_angle = angle_at(running_->start, window);
}

/// The point of the constraint's line or plane under a pixel.
Vec3d ObjectGesture::point_under(const Vec2d& pixel, const GizmoWindow& window) const {
  const ViewRay ray = window.camera.ray(place_of_pixel(pixel, window.size), window.size.x / window.size.y);
  const auto directions = axes(running_->is_local);
  const Vec3d& axis = directions[static_cast<std::size_t>(running_->constraint.axis)];
  const Vec3d& pivot = target_->pivot;
  if (running_->constraint.kind == Constraint::Axis) {
    return pivot + axis * nearest_on_line(pivot, axis, ray).value_or(0);
  }
  Vec3d normal = running_->constraint.kind == Constraint::Plane ? axis : window.camera.forward();
  if (std::abs(normal.dot(ray.direction.normalized())) < 0.05) normal = window.camera.forward();
  const double cosine = normal.dot(ray.direction);
  const Vec3d hit = ray.at(normal.dot(pivot - ray.origin) / cosine);
  if (running_->constraint.kind != Constraint::Plane) return hit;
  return hit - axis * axis.dot(hit - pivot);
}

Vec3d ObjectGesture::rotation_axis() const {
  if (running_->constraint.kind == Constraint::Free) return running_->towards_eye;
  return axes(running_->is_local)[static_cast<std::size_t>(running_->constraint.axis)];
}

/// The angle of the pointer about the axis of rotation, in radians.
double ObjectGesture::angle_at(const Vec2d& pixel, const GizmoWindow& window) const {
  const Vec3d axis = rotation_axis();
  const auto middle = pixel_of(target_->pivot, window.camera, window.size);
  if (!middle) return 0;
  const double facing = axis.dot(running_->towards_eye);
  if (std::abs(facing) < 0.2) {
    // Seen from the side, a ring is turned as a wheel: by the motion across the axis.
    const Vec3d across = running_->towards_eye.cross(axis).normalized();
    const Vec2d way(across.dot(window.camera.right()), -across.dot(window.camera.up()));
    return -(pixel - *middle).dot(way) / GizmoLength;
  }
  const Vec2d at = pixel - *middle;
  return std::atan2(-at.y, at.x) * (facing < 0 ? -1 : 1);
}

void ObjectGesture::move(const Vec2d& pixel, const GizmoWindow& window, bool snaps) {
  running_->now = pixel;
  if (running_->kind == Kind::Translation) follow_move(window, snaps);
  if (running_->kind == Kind::Rotation) follow_rotation(window, snaps);
  if (running_->kind == Kind::Scale) follow_scale(window, snaps);
}

void ObjectGesture::follow_move(const GizmoWindow& window, bool snaps) {
  const Vec3d way = point_under(running_->now, window) - point_under(running_->start, window);
  const auto directions = axes(running_->is_local);
  const double pixel = 2 * window.camera.half_height_at(target_->pivot) / window.size.y;
  const int exponent = static_cast<int>(std::floor(std::log10(pixel)));
  for (int axis = 0; axis < 3; ++axis) {
    const double along = way.dot(directions[static_cast<std::size_t>(axis)]);
    double& offset = running_->offset[axis];
    const bool is_still = std::abs(along) < 1e-9 * (1 + way.length());
    if (is_still) {
      offset = 0;
    } else if (snaps && !running_->is_local) {
      // The pivot comes to lie on the grid.
      offset = rounded_to(target_->pivot[axis] + along, target_->grid_step) - target_->pivot[axis];
    } else if (snaps) {
      offset = rounded_to(along, target_->grid_step);
    } else {
      offset = rounded_to_decimals(along, exponent);
    }
  }
}

void ObjectGesture::follow_rotation(const GizmoWindow& window, bool snaps) {
  const double angle = angle_at(running_->now, window);
  running_->raw_degrees +=
      wrapped(angle - std::exchange(running_->last_angle, angle)) * 180 / std::numbers::pi;
  running_->degrees =
      snaps ? rounded_to(running_->raw_degrees, 5) : rounded_to_decimals(running_->raw_degrees, -1);
}

void ObjectGesture::follow_scale(const GizmoWindow& window, bool snaps) {
  const auto middle = pixel_of(target_->pivot, window.camera, window.size);
  if (!middle) return;
  Vec2d start = running_->start - *middle;
  constexpr double Shortest = 10;
  if (start.length() < Shortest) start = Vec2d(Shortest, 0);
  // The pointer goes on from where it is, also if that was too near to the pivot.
  const Vec2d now = start + (running_->now - running_->start);
  const double factor = now.dot(start) / start.length2();
  running_->factor = snaps ? rounded_to_decimals(factor, -1) : rounded_to_decimals(factor, -2);
}

void ObjectGesture::constrain(int axis, bool to_plane, const GizmoWindow& window) {
  const AxisConstraint wanted{to_plane ? Constraint::Plane : Constraint::Axis, axis};
  if (running_->constraint != wanted) {
    running_->constraint = wanted;
    running_->is_local = target_->is_local;
  } else if (running_->is_local == target_->is_local) {
    running_->is_local = !target_->is_local;
  } else {
    running_->constraint = {};
    running_->is_local = target_->is_local;
  }
  const Vec2d now = running_->now;
  restart(window);
  move(now, window, false);
}

bool ObjectGesture::type(char character) {
  std::string& typed = running_->typed;
  if (character == '\b') {
    if (!typed.empty()) typed.pop_back();
  } else if (character == '-') {
    if (typed.starts_with('-')) {
      typed.erase(0, 1);
    } else {
      typed.insert(0, "-");
    }
  } else if ((character >= '0' && character <= '9') ||
             (character == '.' && typed.find('.') == std::string::npos)) {
    typed += character;
  } else {
    return false;
  }
  return true;
}

std::optional<double> ObjectGesture::typed_number() const {
  double number = 0;
  const std::string& text = running_->typed;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc()) return std::nullopt;
  return number;
}

std::optional<TransformAction> ObjectGesture::action() const {
  if (!running_) return std::nullopt;
  TransformAction action;
  action.kind = running_->kind;
  action.pivot = target_->pivot;
  const auto directions = axes(running_->is_local);
  const AxisConstraint& constraint = running_->constraint;
  const std::optional<double> typed = typed_number();
  if (action.kind == Kind::Translation) {
    Vec3d offset = running_->offset;
    if (typed) {
      // Without an axis the number is along x, in a plane along both of its axes.
      offset = Vec3d(0);
      const bool is_plane = constraint.kind == Constraint::Plane;
      for (int axis = 0; axis < 3; ++axis) {
        if (is_plane != (axis == constraint.axis)) offset[axis] = *typed;
      }
    }
    for (int axis = 0; axis < 3; ++axis)
      action.value += directions[static_cast<std::size_t>(axis)] * offset[axis];
    if (action.value == Vec3d(0)) return std::nullopt;
  } else if (action.kind == Kind::Rotation) {
    action.value = rotation_axis();
    action.degrees = typed.value_or(running_->degrees);
    if (action.degrees == 0) return std::nullopt;
  } else {
    const double factor = typed.value_or(running_->factor);
    action.value = Vec3d(factor);
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_kept = (constraint.kind == Constraint::Axis && axis != constraint.axis) ||
                           (constraint.kind == Constraint::Plane && axis == constraint.axis);
      if (is_kept) action.value[axis] = 1;
      for (int column = 0; column < 3; ++column)
        action.axes[axis][column] = directions[static_cast<std::size_t>(axis)][column];
    }
    if (factor == 1 || factor == 0) return std::nullopt;
  }
  return action;
}

std::string ObjectGesture::text() const {
  if (!running_) return {};
  const AxisConstraint& constraint = running_->constraint;
  static constexpr std::array<const char*, 3> Along = {"x", "y", "z"};
  static constexpr std::array<const char*, 3> Across = {"y and z", "x and z", "x and y"};
  const auto axis = static_cast<std::size_t>(constraint.axis);
  std::string where;
  if (constraint.kind != Constraint::Free) {
    where = fmt::format(
        " {} {}{}", running_->kind == Kind::Rotation ? "about" : "along",
        constraint.kind == Constraint::Axis || running_->kind == Kind::Rotation ? Along[axis] : Across[axis],
        running_->is_local ? " of the object" : "");
  }
  const std::optional<double> typed = typed_number();
  if (running_->kind == Kind::Rotation)
    return fmt::format("Rotate {:g}°{}", typed.value_or(running_->degrees), where);
  if (running_->kind == Kind::Scale)
    return fmt::format("Scale {:g}{}", typed.value_or(running_->factor), where);
  if (typed) return fmt::format("Move {:g}{}", *typed, where.empty() ? " along x" : where);
  const Vec3d& offset = running_->offset;
  return fmt::format("Move {:g}, {:g}, {:g}{}", offset.x, offset.y, offset.z, where);
}

std::optional<TransformAction> ObjectGesture::end() {
  auto made = action();
  cancel();
  return made;
}

SceneObjects transformed(const SceneObjects& objects, const std::vector<grf::ScenePath>& blocks,
                         const TransformAction& action) {
  const auto is_moved = [&blocks](const grf::ScenePath& path) {
    return std::ranges::any_of(blocks, [&path](const auto& block) { return is_inside(path, block); });
  };
  const grf::Matrix44d matrix = action.matrix();
  SceneObjects result = objects;
  for (MeshInstance& instance : result.instances.edit()) {
    if (is_moved(instance.path)) instance.to_world *= matrix;
  }
  for (LightObject& light : result.lights) {
    if (is_moved(light.path)) light.to_world *= matrix;
  }
  for (ObserverObject& observer : result.observers) {
    if (is_moved(observer.path)) observer.position = observer.position * matrix;
  }
  const grf::Box3d before = objects.bounds;
  for (int corner = 0; corner < 8 && !before.isEmpty(); ++corner) {
    const Vec3d at((corner & 1) != 0 ? before.max.x : before.min.x,
                   (corner & 2) != 0 ? before.max.y : before.min.y,
                   (corner & 4) != 0 ? before.max.z : before.min.z);
    result.bounds.extendBy(at * matrix);
  }
  return result;
}

}  // namespace editor
