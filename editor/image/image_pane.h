#pragma once

#include <QImage>
#include <QPoint>
#include <QWidget>
#include <array>
#include <optional>

#include "editor/image/image_entry.h"
#include "editor/image/screen_colours.h"

namespace editor {

/// How an image and its reference share the view.
enum class Arrangement {
  Alone,       ///< only the image
  Reference,   ///< only the reference
  Wipe,        ///< the image left of a line that can be dragged, the reference right of it
  SideBySide,  ///< both, each in a half of the view, at the same zoom and position
};

/// Displays an image of linear radiance. Drag or arrow keys pan, the wheel zooms about the pointer, a double
/// click toggles between fit and actual size; [ and ] move the wipe line.
class ImagePane : public QWidget {
  Q_OBJECT

 public:
  explicit ImagePane(QWidget* parent = nullptr);

  /// Sets the image; null shows none. An image of the same size as before keeps zoom and position.
  void set_image(SharedImage image, const QString& name = {});
  void set_reference(SharedImage reference, const QString& name = {});
  void set_settings(const ScreenSettings& settings);
  void set_arrangement(Arrangement arrangement);
  /// Sets the hint of an empty pane.
  void set_hint(const QString& hint);

  const ScreenSettings& settings() const { return settings_; }
  Arrangement arrangement() const { return arrangement_; }

  /// Device pixels per image pixel.
  double zoom() const { return zoom_; }
  static constexpr double LeastZoom = 1.0 / 64;
  static constexpr double LargestZoom = 256;

  /// Fits the image, also after the pane is resized, until it is zoomed or panned.
  void fit();
  /// Shows one image pixel per device pixel.
  void show_actual_size();
  /// Zooms about a position of the pane.
  void zoom_by(double factor, const QPointF& about);
  void zoom_by(double factor);
  void move_by(const QPointF& offset);
  /// Position of the wipe line: 0 is the left edge, 1 the right one.
  double wipe() const { return wipe_; }
  void set_wipe(double share);

  /// The pixel at a position of the pane, if it lies in the image.
  std::optional<QPoint> pixel_at(const QPointF& place) const;
  /// The centre of a pixel in the pane, in the image's own part.
  QPointF place_of(const QPoint& pixel) const;

  QSize sizeHint() const override { return {640, 400}; }

 signals:
  /// Emitted with the pixel under the pointer, if any.
  void hovered(const std::optional<QPoint>& pixel);
  void zoomed(double zoom);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// Cache of the last drawn part: its encoded colours.
  struct Converted {
    SharedImage image;
    ScreenSettings settings;
    QRect part;
    int block = 0;
    QImage colours;
  };

  double scale() const;
  QSizeF image_size() const;
  QRectF left_view() const;
  QRectF right_view() const;
  bool is_near_wipe(const QPointF& place) const;
  bool shows_two_by(Arrangement arrangement) const;
  void set_zoom(double zoom);
  void keep_in_view();
  void tell_pixel();
  void update_cursor();
  void draw(QPainter& painter, const SharedImage& image, const QRectF& view, const QRectF& clip,
            Converted& cache);
  void draw_name(QPainter& painter, const QString& name, const QRectF& view, Qt::Alignment side);
  void draw_hint(QPainter& painter);
  void draw_wipe(QPainter& painter);

  SharedImage image_;
  SharedImage reference_;
  QString image_name_;
  QString reference_name_;
  QString hint_;
  ScreenSettings settings_;
  Arrangement arrangement_ = Arrangement::Alone;
  QPointF origin_;  ///< upper left corner of the image, in a view
  double zoom_ = 1;
  double wipe_ = 0.5;
  bool fits_ = true;
  bool drags_wipe_ = false;
  std::optional<QPointF> drag_from_;
  std::optional<QPointF> pointer_;
  std::array<Converted, 2> converted_;
};

}  // namespace editor
