// ViewCamera is the camera of the 3D view.
#pragma once

#include <limits>
#include <optional>

#include "grf/math.h"
#include "renderer/transport/camera.h"

namespace editor {

/// A ray in world or local coordinates; with `nearest` below 0 a line.
struct ViewRay {
  grf::Vec3d origin = grf::Vec3d(0);
  grf::Vec3d direction = grf::Vec3d(0, 0, -1);
  double nearest = 0;  ///< near clipping, in lengths of the direction

  grf::Vec3d at(double distance) const { return origin + direction * distance; }
};

/// Transforms the ray; distances along it are unchanged.
ViewRay transformed(const ViewRay& ray, const grf::Matrix44d& matrix);

enum class StandardView { Front, Right, Top };

/// An orbit camera that looks at its target without roll: up is +y. Positions in the image are -1..1 from
/// left to right and from the bottom to the top; `aspect` is width over height.
class ViewCamera {
 public:
  /// Constructs a camera in front of the origin and slightly above.
  ViewCamera() = default;
  /// Uses eye and target of a view, which must differ, and its field of view; roll and lens are ignored.
  explicit ViewCamera(const transport::View& view);

  const grf::Vec3d& target() const { return target_; }
  grf::Vec3d eye() const { return target_ - forward() * distance_; }
  double distance() const { return distance_; }
  grf::Vec3d forward() const;
  grf::Vec3d right() const;
  grf::Vec3d up() const;
  double field_of_view() const { return field_of_view_; }  ///< vertical, degrees
  bool is_orthographic() const { return is_orthographic_; }
  transport::View view() const;

  /// Orbits about the target by so many radians, upwards no further than to the pole.
  void orbit(double to_the_right, double upwards);
  /// Pans by fractions of the image's height at the target.
  void pan(double to_the_right, double upwards);
  /// Dollies in (factor < 1) or out; what is under this position of the image stays there.
  void zoom(double factor, const grf::Vec2d& place, double aspect);
  /// Moves by world units along the camera's own axes.
  void fly(double to_the_right, double upwards, double forwards);
  /// Turns the view direction: the eye stays where it is.
  void look(double to_the_right, double upwards);
  /// Sets the orbit centre. Eye and target are translated by the same vector.
  void set_target(const grf::Vec3d& target);
  void set_orthographic(bool is_orthographic) { is_orthographic_ = is_orthographic; }
  void look_from(StandardView side);
  void look_from_opposite();
  /// Frames a box from the current direction; an empty box changes nothing.
  void frame(const grf::Box3d& box, double aspect);

  grf::Matrix44d world_to_camera() const;
  /// The matrix from camera space to OpenGL clip space, with near and far planes about the box.
  grf::Matrix44d camera_to_clip(double aspect, const grf::Box3d& box) const;
  /// Returns what to subtract from z in clip space so that a line on a face is not hidden by it: in
  /// perspective this moves a point toward the eye by a fixed part of its distance, wherever the near plane
  /// is.
  static float depth_offset(const grf::Matrix44d& camera_to_clip);
  ViewRay ray(const grf::Vec2d& place, double aspect) const;
  /// Projects a point into the image; nothing for one that is not in front of the eye.
  std::optional<grf::Vec2d> place_of(const grf::Vec3d& point, double aspect) const;
  /// Half the height of the view frustum at a point.
  double half_height_at(const grf::Vec3d& point) const;

  bool operator==(const ViewCamera&) const = default;

 private:
  double tangent() const;

  grf::Vec3d target_ = grf::Vec3d(0);
  double distance_ = 5;
  double yaw_ = 0.5;     // about +y: 0 looks along -z, more comes from the right
  double pitch_ = -0.4;  // upwards
  double field_of_view_ = 40;
  bool is_orthographic_ = false;
};

}  // namespace editor
