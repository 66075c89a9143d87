// Moves, rotates and scales the selected objects with the pointer or by typed numbers: the gizmo of a view.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "editor/document/object_placement.h"
#include "editor/view/view_camera.h"

namespace editor {

/// What a gesture may change: everything (a scale is uniform), along one axis, or in the plane across it.
struct AxisConstraint {
  enum class Kind { Free, Axis, Plane };
  Kind kind = Kind::Free;
  int axis = 0;  ///< 0 to 2 of the axes

  bool operator==(const AxisConstraint&) const = default;
};

/// The objects that a gizmo transforms.
struct GizmoTarget {
  std::vector<grf::ScenePath> blocks;
  grf::Vec3d pivot;           ///< world space
  grf::Matrix44d local_axes;  ///< orthonormal axes of the active object
  bool is_local = false;      ///< whether the gizmo has these axes instead of the world's
  double grid_step = 1;       ///< snapping increment of moves
};

/// A camera and the size of its window in pixels.
struct GizmoWindow {
  const ViewCamera& camera;
  grf::Vec2d size;
};

/// The gizmo and its gesture. A gesture begins by a drag of a part of the gizmo, or by a key without a
/// button; then the axis may be chosen by X, Y and Z, and a number may be typed. Pixels are from the upper
/// left. Values are rounded to decimals below the size of a pixel: degrees to 0.1, factors to 0.01.
class ObjectGesture {
 public:
  using Kind = grf::TransformStep::Kind;
  struct Line {
    grf::Vec2d from, to;        ///< pixels
    AxisConstraint constraint;  ///< of the part that it belongs to
    bool is_lit = false;
  };

  /// Sets the objects; none hides the gizmo and cancels the gesture.
  void set_target(std::optional<GizmoTarget> target);
  const std::optional<GizmoTarget>& target() const { return target_; }
  /// Sets which gizmo is shown; none shows none, while gestures by keys remain possible.
  void set_tool(std::optional<Kind> tool) { tool_ = tool; }
  std::optional<Kind> tool() const { return tool_; }

  /// The lines of the gizmo, or of the axes of the gesture that runs.
  std::vector<Line> lines(const GizmoWindow& window) const;
  /// The part of the gizmo at a pixel, within some pixels.
  std::optional<AxisConstraint> part_at(const grf::Vec2d& pixel, const GizmoWindow& window) const;
  /// Lights the part at a pixel, if any. Returns whether that changed.
  bool hover(const std::optional<AxisConstraint>& part);

  bool is_active() const { return running_.has_value(); }
  void begin(Kind kind, const AxisConstraint& constraint, const grf::Vec2d& pixel, const GizmoWindow& window);
  /// Follows the pointer; `snaps` rounds to grid steps, 5 degrees or factors of 0.1.
  void move(const grf::Vec2d& pixel, const GizmoWindow& window, bool snaps);
  /// Constrains to an axis, or to the plane across it: in the gizmo's axes, with the same key once more in
  /// the other axes, then free again.
  void constrain(int axis, bool to_plane, const GizmoWindow& window);
  /// Appends a digit, point or minus to the typed number; a backspace removes the last one. Returns whether
  /// the character is one of these.
  bool type(char character);
  /// The action so far; none while nothing would change.
  std::optional<TransformAction> action() const;
  /// Describes the gesture, as `Move 0.5 along x`.
  std::string text() const;
  std::optional<TransformAction> end();
  void cancel() { running_.reset(); }

 private:
  struct Running {
    Kind kind;
    AxisConstraint constraint;
    bool is_local;
    grf::Vec2d start, now;
    grf::Vec3d offset = grf::Vec3d(0);  // along the axes
    double degrees = 0;
    double raw_degrees = 0;  // not rounded
    double last_angle = 0;   // radians
    grf::Vec3d towards_eye;
    double factor = 1;
    std::string typed;
  };

  std::array<grf::Vec3d, 3> axes(bool is_local) const;
  void restart(const GizmoWindow& window);
  grf::Vec3d point_under(const grf::Vec2d& pixel, const GizmoWindow& window) const;
  double angle_at(const grf::Vec2d& pixel, const GizmoWindow& window) const;
  void follow_move(const GizmoWindow& window, bool snaps);
  void follow_rotation(const GizmoWindow& window, bool snaps);
  void follow_scale(const GizmoWindow& window, bool snaps);
  std::optional<double> typed_number() const;
  grf::Vec3d rotation_axis() const;

  std::optional<GizmoTarget> target_;
  std::optional<Kind> tool_;
  std::optional<AxisConstraint> hovered_;
  std::optional<Running> running_;
};

/// The objects as they will be after an action: instances and lights inside these blocks are transformed.
SceneObjects transformed(const SceneObjects& objects, const std::vector<grf::ScenePath>& blocks,
                         const TransformAction& action);

}  // namespace editor
