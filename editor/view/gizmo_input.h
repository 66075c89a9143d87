#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "editor/view/object_gesture.h"

class QKeyEvent;
class QMouseEvent;

namespace editor {

class SceneView;
struct OverlayLine;

/// Lets the pointer and the keys transform the selected objects in a view: it watches the view's events,
/// draws the gizmo, and shows the objects as they will be. It edits nothing.
///
/// A part of the gizmo is dragged; or `begin` starts a gesture that follows the pointer without a button
/// until a click or Return, where X, Y and Z choose an axis, with Shift the plane across it, and digits give
/// the value. Ctrl snaps. Escape and the right button cancel.
class GizmoInput : public QObject {
  Q_OBJECT

 public:
  /// The view outlives it.
  explicit GizmoInput(SceneView& view);

  void set_target(std::optional<GizmoTarget> target);
  /// Sets which gizmo is shown, if any.
  void set_tool(std::optional<ObjectGesture::Kind> tool);
  /// Starts a gesture at the pointer. Does nothing without a target.
  void begin(ObjectGesture::Kind kind);
  /// Makes gestures snap without Ctrl.
  void set_snapping(bool snaps) { snaps_ = snaps; }
  const ObjectGesture& gesture() const { return gesture_; }

 signals:
  /// Emitted once a gesture has ended.
  void transform_made(const editor::TransformAction& action);
  /// Emitted with a description of the gesture that runs; empty after it.
  void status_message(const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool press_key(const QKeyEvent& event);
  bool is_for_view(const QKeyEvent& event) const;
  void follow(bool has_ctrl);
  void show();
  void finish();
  void cancel();
  std::vector<OverlayLine> lines(const ViewCamera& camera, const grf::Vec2d& size) const;

  SceneView& view_;
  ObjectGesture gesture_;
  bool snaps_ = false;
  bool is_dragging_ = false;      // with the button
  bool ignores_release_ = false;  // of the button that ended a gesture
  std::optional<QPointF> pointer_;
  QPointF pressed_at_;
};

}  // namespace editor
