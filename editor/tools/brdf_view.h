#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <deque>

#include "editor/tools/brdf_renderer.h"

namespace editor {

/// Shows the BRDF viewer's object. The pointer or the arrow keys turn it, or move the light.
class BrdfView : public QWidget {
  Q_OBJECT

 public:
  explicit BrdfView(const GraphicsDriver& driver = {}, QWidget* parent = nullptr);

  /// What dragging with the left button, and the arrow keys, do. The right button does the other.
  enum class Tool { Turn, Light };
  void set_tool(Tool tool);
  Tool tool() const { return tool_; }

  /// Shows a scene, whose size and background are the view's.
  void show_scene(const BrdfScene& scene);
  const BrdfScene& scene() const { return scene_; }
  /// Shows a hint instead, if there is no object.
  void show_hint(const QString& hint);

  const BrdfImage& image() const { return image_; }
  /// Whether the image is older than the scene, or not refined yet.
  bool is_busy() const;
  /// Whether the image is of the scene, perhaps as a draft.
  bool is_current() const { return image_.number == requested_; }
  /// Frames per second of the last second's drafts; 0 for less than two.
  double frames_per_second() const;

  QSize sizeHint() const override;

 signals:
  void drawn();
  void turned(const QPointF& by, bool is_done);  ///< by so many device-independent pixels
  /// The light is to shine from this direction, in world space.
  void light_moved(const reflectance::Vec3f& direction, bool is_done);
  void light_turned(const QPointF& by);  ///< by so many degrees, to the right and upwards
  void split_moved(double split, bool is_done);
  void zoomed(double factor);
  void exposed(double stops);
  void probed(const editor::PixelProbe& probe);
  void pointer_left();
  void failed(const QString& message);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  enum class Drag { None, Turn, Light, Split };

  void request();
  void take(const BrdfImage& image);
  QPoint pixel_at(const QPointF& position) const;
  bool is_near_split(const QPointF& position) const;
  reflectance::Vec3f light_at(const QPointF& position) const;
  void drag(const QPointF& position, bool is_done);

  Tool tool_ = Tool::Turn;
  Drag drag_ = Drag::None;
  QPointF grabbed_at_;
  BrdfScene scene_;
  QString hint_;
  BrdfImage image_;
  int requested_ = 0;
  QElapsedTimer clock_;
  std::deque<qint64> drafts_;  ///< when they came, milliseconds
  BrdfRenderer renderer_;
};

}  // namespace editor
