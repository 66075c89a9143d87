#pragma once

#include <QImage>
#include <QWidget>
#include <string>

#include "editor/jobs/background_job.h"

namespace editor {

/// Shows a figure, as large as fits, rendered in a thread. The pointer can point at its parts, and drag it,
/// for figures that are turned; the arrow keys turn it, too.
class FigureView : public QWidget {
  Q_OBJECT

 public:
  explicit FigureView(QWidget* parent = nullptr);

  /// Shows a figure of this size in its own units.
  void show_figure(std::string svg, const QSizeF& size);
  /// Shows a hint instead of a figure.
  void show_hint(const QString& hint);
  /// Whether a figure is being rendered.
  bool is_busy() const { return job_.is_busy(); }
  const QImage& image() const { return image_; }

  /// Maps a position in the widget to a position in the figure.
  QPointF in_figure(const QPointF& position) const;
  QPointF in_widget(const QPointF& of_figure) const;

  QSize sizeHint() const override;

 signals:
  void rendered();
  void pointed(const QPointF& of_figure);  ///< the pointer moved without a button
  void pointer_left();
  /// Dragged by so many device-independent pixels; `is_done` on release.
  void turned(const QPointF& by, bool is_done);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void render();
  double scale() const;

  std::string svg_;
  QSizeF size_;
  QString hint_;
  QImage image_;
  QPointF grabbed_at_;
  BackgroundJob<QImage> job_{this};
};

}  // namespace editor
