#pragma once

#include <QImage>
#include <QWidget>
#include <memory>

#include <QMatrix4x4>

#include "editor/brdf/lobe_curves.h"
#include "editor/graphics/graphics_thread.h"
#include "editor/jobs/background_job.h"
#include "renderer/plot/lobe_mesh.h"

namespace editor {

class LobePainter;
struct LobePicture;

/// The 3D lobe of a BRDF over the disc of the surface, with the view, specular and half directions. The
/// pointer and the arrow keys orbit it.
class LobeView : public QWidget {
  Q_OBJECT

 public:
  explicit LobeView(QWidget* parent = nullptr);
  ~LobeView() override;

  /// Sets the BRDF; for null, the hint is shown instead.
  void set_brdf(SharedBrdf brdf, const QString& hint = {});
  /// Sets the view angle in degrees from the normal, from 0 to below 90.
  void set_view(double degrees);
  double view() const { return view_; }
  void set_with_cosine(bool with_cosine);
  void set_logarithmic(bool is_logarithmic);

  const plot::LobeMesh& mesh() const { return *mesh_; }
  bool is_busy() const { return job_.is_busy() || is_drawing_; }
  /// Angle about the normal, and elevation over the surface, in degrees.
  double azimuth() const { return azimuth_; }
  double elevation() const { return elevation_; }

  QSize sizeHint() const override;

 signals:
  void updated();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void compute();
  void draw();
  LobePicture picture() const;
  void paint_over(QPainter& painter, const QMatrix4x4& matrix) const;
  void turn(double azimuth, double elevation);
  QMatrix4x4 to_clip() const;
  QPointF place_of(const reflectance::Vec3f& point, const QMatrix4x4& matrix) const;

  SharedBrdf brdf_;
  QString hint_;  // instead of a lobe
  std::shared_ptr<const plot::LobeMesh> mesh_;
  double view_ = 45;
  bool with_cosine_ = true;
  bool is_logarithmic_ = false;
  double azimuth_ = 60;
  double elevation_ = 25;
  double zoom_ = 1;
  QPointF grabbed_at_;
  bool is_old_ = true;
  BackgroundJob<plot::LobeMesh> job_{this};
  QImage drawn_;
  QMatrix4x4 drawn_to_clip_;
  bool is_drawing_ = false;
  bool is_drawn_old_ = false;             // what is drawn now is not what is to be seen any more
  std::unique_ptr<LobePainter> painter_;  // of the thread
  GraphicsThread thread_;
};

}  // namespace editor
