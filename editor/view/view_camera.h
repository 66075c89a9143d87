// From where the 3D view is seen.
#pragma once

#include <limits>
#include <optional>

#include "grf/math.h"
#include "renderer/transport/camera.h"

namespace editor {

/// A half line, or with `nearest` below 0 a line, in the world or in a mesh's coordinates.
struct ViewRay {
  grf::Vec3d origin = grf::Vec3d(0);
  grf::Vec3d direction = grf::Vec3d(0, 0, -1);
  double nearest = 0;  ///< what is nearer, in lengths of the direction, is not seen

  grf::Vec3d at(double distance) const { return origin + direction * distance; }
};

/// The same ray in coordinates that the matrix leads to; distances along it stay the same.
ViewRay transformed(const ViewRay& ray, const grf::Matrix44d& matrix);

enum class StandardView { Front, Right, Top };

/// An eye that looks at the centre of its orbit and is never tilted sideways: up is +y. Places in the image
/// are -1..1 from left to right and from the bottom to the top; `aspect` is the image's width over its
/// height.
class ViewCamera {
 public:
  /// In front of the origin and slightly above.
  ViewCamera() = default;
  /// The eye and the point looked at, which must differ; what the view has besides is left out.
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

  /// Turns about the target by so many radians, upwards no further than to the pole.
  void orbit(double to_the_right, double upwards);
  /// Moves eye and target by parts of the image's height at the target.
  void pan(double to_the_right, double upwards);
  /// Brings the eye nearer (factor < 1) or takes it away; what is under this place of the image stays there.
  void zoom(double factor, const grf::Vec2d& place, double aspect);
  /// Moves by so many world units along the view's own axes.
  void fly(double to_the_right, double upwards, double forwards);
  /// Turns the head: the eye stays where it is.
  void look(double to_the_right, double upwards);
  /// Turns about this point from now on. Eye and target move aside by as much.
  void set_target(const grf::Vec3d& target);
  void set_orthographic(bool is_orthographic) { is_orthographic_ = is_orthographic; }
  void look_from(StandardView side);
  void look_from_opposite();
  /// Sees the whole box from the same side; an empty box changes nothing.
  void frame(const grf::Box3d& box, double aspect);

  grf::Matrix44d world_to_camera() const;
  /// From the camera's coordinates to OpenGL's clip coordinates, with near and far planes about the box.
  grf::Matrix44d camera_to_clip(double aspect, const grf::Box3d& box) const;
  ViewRay ray(const grf::Vec2d& place, double aspect) const;
  /// Where in the image a point is, or nothing for one that is not in front of the eye.
  std::optional<grf::Vec2d> place_of(const grf::Vec3d& point, double aspect) const;
  /// Half the height of what is seen at a point.
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
