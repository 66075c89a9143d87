#include "editor/view/gizmo_input.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <utility>

#include "editor/appearance/theme.h"
#include "editor/view/scene_view.h"
#include "editor/view/view_overlay.h"

namespace editor {
namespace {

grf::Vec2d pixel_at(const QPointF& point) { return {point.x(), point.y()}; }

}  // namespace

GizmoInput::GizmoInput(SceneView& view) : QObject(&view), view_(view) {
  view_.installEventFilter(this);
  view_.set_gizmo([this](const ViewCamera& camera, const grf::Vec2d& size) { return lines(camera, size); });
}

void GizmoInput::set_target(std::optional<GizmoTarget> target) {
  if (gesture_.is_active()) cancel();
  gesture_.set_target(std::move(target));
  view_.draw();
}

void GizmoInput::set_tool(std::optional<ObjectGesture::Kind> tool) {
  gesture_.set_tool(tool);
  view_.draw();
}

void GizmoInput::begin(ObjectGesture::Kind kind) {
  if (!gesture_.target() || gesture_.is_active()) return;
  const grf::Vec2d size = view_.window_size();
  const grf::Vec2d at = pointer_ ? pixel_at(*pointer_) : size / 2;
  gesture_.begin(kind, {}, at, {view_.camera(), size});
  is_dragging_ = false;
  view_.setFocus();
  show();
}

std::vector<OverlayLine> GizmoInput::lines(const ViewCamera& camera, const grf::Vec2d& size) const {
  if (view_.has_region_tool() && !gesture_.is_active()) return {};
  const QColor neutral = colours_of(theme_of(view_.palette())).text;
  std::vector<OverlayLine> result;
  for (const ObjectGesture::Line& line : gesture_.lines({camera, size})) {
    QColor colour =
        line.constraint.kind == AxisConstraint::Kind::Free ? neutral : axis_colour(line.constraint.axis);
    if (line.is_lit) colour = view_colours(view_.palette()).accent;
    result.push_back({grf::Vec3d(line.from.x, line.from.y, 0), grf::Vec3d(line.to.x, line.to.y, 0), colour});
  }
  return result;
}

bool GizmoInput::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      return press(static_cast<QMouseEvent&>(*event));
    case QEvent::MouseMove:
      return move(static_cast<QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease:
      return release(static_cast<QMouseEvent&>(*event));
    case QEvent::ShortcutOverride: {
      const bool is_taken = is_for_view(static_cast<QKeyEvent&>(*event));
      if (is_taken) event->accept();
      return is_taken;
    }
    case QEvent::KeyPress:
      return gesture_.is_active() && press_key(static_cast<QKeyEvent&>(*event));
    case QEvent::Leave:
      pointer_.reset();
      if (gesture_.hover(std::nullopt)) view_.draw();
      return false;
    default:
      return QObject::eventFilter(watched, event);
  }
}

/// Letters without Ctrl or Alt are for a gesture that runs, or for flying while the right button is held.
bool GizmoInput::is_for_view(const QKeyEvent& event) const {
  const bool has_other = event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
  return !has_other && (gesture_.is_active() || QGuiApplication::mouseButtons().testFlag(Qt::RightButton));
}

bool GizmoInput::press(const QMouseEvent& event) {
  pointer_ = event.position();
  if (gesture_.is_active()) {
    ignores_release_ = true;
    if (event.button() == Qt::LeftButton) finish();
    if (event.button() == Qt::RightButton) cancel();
    return true;
  }
  const bool is_selecting = event.modifiers() & (Qt::ShiftModifier | Qt::AltModifier);
  if (event.button() != Qt::LeftButton || is_selecting || !gesture_.tool() || view_.has_region_tool())
    return false;
  const GizmoWindow window{view_.camera(), view_.window_size()};
  const auto part = gesture_.part_at(pixel_at(*pointer_), window);
  if (!part) return false;
  view_.setFocus(Qt::MouseFocusReason);
  gesture_.begin(*gesture_.tool(), *part, pixel_at(*pointer_), window);
  is_dragging_ = true;
  pressed_at_ = event.position();
  show();
  return true;
}

bool GizmoInput::move(const QMouseEvent& event) {
  pointer_ = event.position();
  if (gesture_.is_active()) {
    follow(event.modifiers().testFlag(Qt::ControlModifier));
    return true;
  }
  if (event.buttons() != Qt::NoButton) return false;
  const auto part = gesture_.part_at(pixel_at(*pointer_), {view_.camera(), view_.window_size()});
  if (gesture_.hover(part)) view_.draw();
  return false;
}

bool GizmoInput::release(const QMouseEvent& event) {
  if (std::exchange(ignores_release_, false)) return true;
  if (!is_dragging_ || !gesture_.is_active() || event.button() != Qt::LeftButton) return false;
  if (event.position() == pressed_at_) {
    // What lies behind the gizmo can be clicked.
    cancel();
    view_.click(event.position(), event.modifiers());
    return true;
  }
  pointer_ = event.position();
  follow(event.modifiers().testFlag(Qt::ControlModifier));
  finish();
  return true;
}

bool GizmoInput::press_key(const QKeyEvent& event) {
  const GizmoWindow window{view_.camera(), view_.window_size()};
  const bool has_shift = event.modifiers().testFlag(Qt::ShiftModifier);
  switch (event.key()) {
    case Qt::Key_Escape:
      cancel();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      finish();
      return true;
    case Qt::Key_X:
    case Qt::Key_Y:
    case Qt::Key_Z:
      gesture_.constrain(event.key() - Qt::Key_X, has_shift, window);
      break;
    case Qt::Key_Backspace:
      gesture_.type('\b');
      break;
    default:
      if (event.text().size() == 1) gesture_.type(event.text().front().toLatin1());
  }
  show();
  return true;
}

void GizmoInput::follow(bool has_ctrl) {
  gesture_.move(pixel_at(*pointer_), {view_.camera(), view_.window_size()}, snaps_ != has_ctrl);
  show();
}

/// Shows the objects as the gesture would leave them.
void GizmoInput::show() {
  const auto action = gesture_.action();
  view_.show_moved(action ? std::make_shared<const SceneObjects>(
                                transformed(view_.objects(), gesture_.target()->blocks, *action))
                          : nullptr);
  emit status_message(QString::fromStdString(gesture_.text()));
}

/// The moved objects stay until the scene is updated.
void GizmoInput::finish() {
  is_dragging_ = false;
  const auto action = gesture_.end();
  emit status_message({});
  if (action) {
    emit transform_made(*action);
  } else {
    view_.show_moved(nullptr);
  }
}

void GizmoInput::cancel() {
  is_dragging_ = false;
  gesture_.cancel();
  view_.show_moved(nullptr);
  emit status_message({});
}

}  // namespace editor
