#include "editor/view/region_input.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPathStroker>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/view/region_selection.h"
#include "editor/view/scene_view.h"
#include "editor/view/view_overlay.h"

namespace editor {
namespace {

constexpr double LeastRadius = 2;
constexpr double LargestRadius = 400;
/// The factor of the brush's radius per key press or step of the wheel.
constexpr double RadiusStep = 1.2;

/// The pixels under a brush that moves along a line.
QPainterPath brushed(const QPolygonF& stroke, double radius) {
  QPainterPath path;
  path.setFillRule(Qt::WindingFill);
  const bool is_dot = std::ranges::all_of(stroke, [&](const QPointF& each) { return each == stroke[0]; });
  if (is_dot) {
    path.addEllipse(stroke[0], radius, radius);
    return path;
  }
  path.addPolygon(stroke);
  QPainterPathStroker stroker;
  stroker.setWidth(2 * radius);
  stroker.setCapStyle(Qt::RoundCap);
  stroker.setJoinStyle(Qt::RoundJoin);
  return stroker.createStroke(path);
}

}  // namespace

RegionInput::RegionInput(SceneView& view) : QObject(&view), view_(view) {
  view_.installEventFilter(this);
  // The view evaluates one region at a time; the brush goes on meanwhile.
  connect(&view_, &SceneView::region_selected, this, &RegionInput::paint_with_brush);
}

void RegionInput::set_tool(std::optional<Tool> tool) {
  if (tool == tool_) return;
  tool_ = tool;
  strokes_.clear();
  corners_.clear();
  is_pressed_ = false;
  view_.set_tool_painter(tool ? SceneView::ToolPainter([this](QPainter& painter) { draw(painter); })
                              : SceneView::ToolPainter());
  if (tool) {
    view_.setCursor(Qt::CrossCursor);
    view_.setFocus();
  } else {
    view_.unsetCursor();
  }
}

bool RegionInput::eventFilter(QObject* watched, QEvent* event) {
  if (!tool_) return QObject::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(static_cast<QMouseEvent&>(*event));
    case QEvent::MouseButtonDblClick:
      return double_click(static_cast<QMouseEvent&>(*event));
    case QEvent::MouseMove:
      return move(static_cast<QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease:
      return release(static_cast<QMouseEvent&>(*event));
    case QEvent::Wheel:
      return turn_wheel(static_cast<QWheelEvent&>(*event));
    case QEvent::ShortcutOverride: {
      const bool is_taken = is_key(static_cast<QKeyEvent&>(*event));
      if (is_taken) event->accept();
      return is_taken;
    }
    case QEvent::KeyPress:
      return press_key(static_cast<QKeyEvent&>(*event));
    case QEvent::Leave:
      pointer_.reset();
      view_.update();
      return false;
    default:
      return QObject::eventFilter(watched, event);
  }
}

/// Drags with Alt remain lassos, and clicks with Alt select loops.
bool RegionInput::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || event.modifiers().testFlag(Qt::AltModifier)) return false;
  view_.setFocus(Qt::MouseFocusReason);
  pointer_ = event.position();
  is_pressed_ = true;
  if (*tool_ == Tool::Brush) {
    stroke_end_ = event.position();
    stroke_removes_ = event.modifiers().testFlag(Qt::ControlModifier);
    strokes_.push_back({QPolygonF({stroke_end_}), stroke_removes_});
    paint_with_brush();
  } else {
    if (corners_.isEmpty()) modifiers_ = {};
    modifiers_ |= event.modifiers();
    corners_ << event.position();
  }
  view_.update();
  return true;
}

bool RegionInput::move(const QMouseEvent& event) {
  pointer_ = event.position();
  view_.update();
  if (!is_pressed_) return false;
  if (*tool_ == Tool::Brush) {
    if (strokes_.empty()) strokes_.push_back({QPolygonF({stroke_end_}), stroke_removes_});
    strokes_.back().points << event.position();
    stroke_end_ = event.position();
    paint_with_brush();
  }
  return true;
}

bool RegionInput::release(const QMouseEvent& event) {
  return event.button() == Qt::LeftButton && std::exchange(is_pressed_, false);
}

/// The first press of a double click has set the last corner.
bool RegionInput::double_click(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || *tool_ == Tool::Brush) return press(event);
  modifiers_ |= event.modifiers();
  is_pressed_ = true;
  close_polygon();
  return true;
}

bool RegionInput::turn_wheel(const QWheelEvent& event) {
  if (*tool_ != Tool::Brush || !event.modifiers().testFlag(Qt::ShiftModifier)) return false;
  scale_brush(std::pow(RadiusStep, event.angleDelta().y() / 120.0));
  return true;
}

bool RegionInput::is_key(const QKeyEvent& event) const {
  switch (event.key()) {
    case Qt::Key_Escape:
      return true;
    case Qt::Key_BracketLeft:
    case Qt::Key_BracketRight:
      return *tool_ == Tool::Brush;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Backspace:
      return *tool_ == Tool::Polygon;
    default:
      return false;
  }
}

bool RegionInput::press_key(const QKeyEvent& event) {
  if (!is_key(event)) return false;
  switch (event.key()) {
    case Qt::Key_Escape:
      set_tool(std::nullopt);
      emit ended();
      break;
    case Qt::Key_BracketLeft:
      scale_brush(1 / RadiusStep);
      break;
    case Qt::Key_BracketRight:
      scale_brush(RadiusStep);
      break;
    case Qt::Key_Backspace:
      if (!corners_.isEmpty()) corners_.removeLast();
      view_.update();
      break;
    default:
      modifiers_ |= event.modifiers() & (Qt::ShiftModifier | Qt::ControlModifier);
      close_polygon();
  }
  return true;
}

void RegionInput::scale_brush(double factor) {
  radius_ = std::clamp(radius_ * factor, LeastRadius, LargestRadius);
  view_.update();
}

/// Selects under the first stroke as far as it goes; another one continues it while the button is held.
void RegionInput::paint_with_brush() {
  if (strokes_.empty() || view_.is_selecting()) return;
  const Stroke stroke = std::move(strokes_.front());
  strokes_.pop_front();
  view_.select_region(brushed(stroke.points, radius_),
                      stroke.removes ? Qt::ControlModifier : Qt::ShiftModifier);
}

void RegionInput::close_polygon() {
  const QPolygonF corners = std::exchange(corners_, {});
  if (corners.size() >= 3) view_.select_region(path_of(corners), modifiers_);
  view_.update();
}

void RegionInput::draw(QPainter& painter) const {
  // A dark halo keeps the lines apart from selected faces, which have the same colour.
  const QPen line = painter.pen();
  painter.setPen(QPen(QColor(0, 0, 0, 140), line.widthF() + 2.5));
  draw_lines(painter);
  painter.setPen(line);
  draw_lines(painter);
}

void RegionInput::draw_lines(QPainter& painter) const {
  if (*tool_ == Tool::Brush) {
    if (pointer_) painter.drawEllipse(*pointer_, radius_, radius_);
    return;
  }
  if (corners_.isEmpty()) return;
  QPolygonF outline = corners_;
  if (pointer_) outline << *pointer_;
  painter.drawPolyline(outline);
  for (const QPointF& corner : corners_) painter.drawEllipse(corner, 2.5, 2.5);
  painter.setPen(QPen(painter.pen().color(), painter.pen().widthF(), Qt::DashLine));
  painter.drawLine(outline.last(), outline.first());
}

}  // namespace editor
