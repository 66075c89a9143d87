#pragma once

#include <QImage>
#include <QWidget>
#include <optional>

#include "editor/brdf/sphere_renderer.h"

namespace editor {

/// A sphere with a BRDF under a sky and a light that the pointer or the arrow keys move, or in the
/// environment of a scene, seen along -z. It is shaded progressively, and exposed for the screen.
class LiveSphere : public QWidget {
  Q_OBJECT

 public:
  explicit LiveSphere(QWidget* parent = nullptr, const GraphicsDriver& driver = {});

  /// Sets the BRDF; for null, the hint is shown instead: why not, or what to do.
  void set_brdf(SharedBrdf brdf, const QString& hint = {});
  /// Sets the exposure in stops.
  void set_exposure(double stops);
  double exposure() const { return exposure_; }

  /// Direction towards the light: x to the right, y up, z to the eye.
  const reflectance::Vec3f& light() const { return scene_.light; }
  void set_light(const reflectance::Vec3f& light);

  /// Sets the environment map that lights the sphere instead of the sky and the light; empty: none.
  void set_environment(const std::optional<studies::Environment>& environment);

  const SphereImage& image() const { return image_; }
  bool is_busy() const { return renderer_.is_busy(); }

  QSize sizeHint() const override;

 signals:
  void shaded();
  /// See SphereRenderer.
  void warned(const QString& message);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void request();
  void show_image();
  QRectF picture_place() const;
  void move_highlight(const QPointF& pointer);

  SphereScene scene_;
  QString hint_;
  SphereImage image_;
  QImage picture_;
  double exposure_ = 0;
  SphereRenderer renderer_;
};

}  // namespace editor
