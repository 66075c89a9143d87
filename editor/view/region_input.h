#pragma once

#include <QObject>
#include <QPainterPath>
#include <QPolygonF>
#include <deque>
#include <optional>

class QKeyEvent;
class QMouseEvent;
class QPainter;
class QWheelEvent;

namespace editor {

class SceneView;

/// Tools that select faces in regions of a view: a brush, and a polygon. It watches the view's events.
///
/// A drag with the brush adds the faces under it, with Ctrl it removes them; [ and ], or Shift and the wheel,
/// change its radius. Each click adds a corner to the polygon, Backspace removes the last one, Return or a
/// double click selects inside; Shift adds, Ctrl removes. Escape ends either tool.
class RegionInput : public QObject {
  Q_OBJECT

 public:
  enum class Tool { Brush, Polygon };

  /// The view outlives it.
  explicit RegionInput(SceneView& view);

  void set_tool(std::optional<Tool> tool);
  std::optional<Tool> tool() const { return tool_; }
  /// The radius of the brush, logical pixels.
  double radius() const { return radius_; }

 signals:
  /// Emitted when Escape has ended the tool.
  void ended();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// A way of the brush with the button held.
  struct Stroke {
    QPolygonF points;
    bool removes = false;
  };

  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool double_click(const QMouseEvent& event);
  bool turn_wheel(const QWheelEvent& event);
  bool is_key(const QKeyEvent& event) const;
  bool press_key(const QKeyEvent& event);
  void scale_brush(double factor);
  void paint_with_brush();
  void close_polygon();
  void draw(QPainter& painter) const;
  void draw_lines(QPainter& painter) const;

  SceneView& view_;
  std::optional<Tool> tool_;
  double radius_ = 30;
  std::optional<QPointF> pointer_;
  QPointF stroke_end_;
  bool stroke_removes_ = false;
  bool is_pressed_ = false;
  std::deque<Stroke> strokes_;       ///< of the brush, not selected yet
  QPolygonF corners_;                ///< of the polygon
  Qt::KeyboardModifiers modifiers_;  ///< of the polygon's clicks
};

}  // namespace editor
