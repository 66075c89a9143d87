#pragma once

#include <QPixmap>
#include <QTransform>
#include <QWidget>
#include <optional>

#include "editor/panels/texture_image.h"

class QTimer;

namespace editor {

/// Draws faces at their texture coordinates over the image, which is repeated around. A drag or the arrow
/// keys move the coordinates, the wheel or `+` and `-` zoom, the middle button pans, and `0` fits.
class UvView : public QWidget {
  Q_OBJECT

 public:
  explicit UvView(QWidget* parent = nullptr);

  /// Shows an image file; an empty path shows the square of the coordinates from 0 to 1.
  void show_image(const QString& path) { image_.load(path); }
  const TextureImage& image() const { return image_; }
  void show_outlines(QVector<QPolygonF> outlines);
  const QVector<QPolygonF>& outlines() const { return outlines_; }
  /// Shows the outlines under a transform until the next ones.
  void show_transform(const QTransform& transform);

  /// Ends a gesture without a signal.
  void cancel_gesture();

  /// Fits the image and the outlines, also after the view is resized, until it is zoomed or panned.
  void fit();
  /// Fits what is new, unless the view was zoomed or panned.
  void refit();
  /// Zooms about a position of the view.
  void zoom_by(double factor, const QPointF& about);

  /// The position of texture coordinates in the view.
  QPointF place_of(const QPointF& uv) const { return to_pixels_.map(uv); }
  QPointF uv_at(const QPointF& place) const { return to_pixels_.inverted().map(place); }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// Emitted while the coordinates are moved, with the offset since the gesture began.
  void moving(const QPointF& offset);
  /// Emitted when the gesture is over.
  void moved();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QSizeF unit() const;
  QRectF contents() const;
  void draw_image(QPainter& painter);
  void draw_borders(QPainter& painter);
  const QPixmap& scaled_image(const QSize& device_size);
  void nudge(const QPointF& offset);

  TextureImage image_;
  QVector<QPolygonF> outlines_;
  QTransform shown_transform_;  ///< of the outlines
  QTransform to_pixels_;        ///< from texture coordinates
  bool fits_ = true;
  std::optional<QPointF> move_from_;  ///< texture coordinates
  std::optional<QPointF> pan_from_;   ///< pixels
  QPointF nudged_;                    ///< by keys, since the gesture began
  QTimer* settling_;                  ///< key presses that follow each other closely are one gesture
  QPixmap scaled_;                    ///< the image at the size of the last drawing
};

}  // namespace editor
