#include "editor/brdf/lobe_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "editor/appearance/theme.h"
#include "editor/brdf/lobe_painter.h"
#include "editor/controls/expression.h"
#include "editor/controls/gesture.h"

namespace editor {
namespace {

using reflectance::Vec3f;

/// Direction towards the eye.
QVector3D eye_direction(double azimuth, double elevation) {
  const double a = azimuth * std::numbers::pi / 180;
  const double e = elevation * std::numbers::pi / 180;
  return QVector3D(static_cast<float>(std::cos(e) * std::sin(a)),
                   static_cast<float>(-std::cos(e) * std::cos(a)), static_cast<float>(std::sin(e)));
}

}  // namespace

LobeView::LobeView(QWidget* parent)
    : QWidget(parent),
      mesh_(std::make_shared<const plot::LobeMesh>()),
      thread_("lobe", [this] { painter_.reset(); }) {
  setMinimumSize(16 * Grid, 16 * Grid);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Lobe of the BRDF"));
  setToolTip(tr(
      "3D lobe: the value in 1/sr for all light directions. Drag or use the arrow keys to orbit, the wheel "
      "to zoom; Page Up and Page Down change the view angle by 5 degrees"));
}

LobeView::~LobeView() = default;

QSize LobeView::sizeHint() const { return {40 * Grid, 25 * Grid}; }

void LobeView::set_brdf(SharedBrdf brdf, const QString& hint) {
  brdf_ = std::move(brdf);
  hint_ = hint;
  setAccessibleDescription(hint);
  is_old_ = true;
  compute();
}

void LobeView::set_view(double degrees) {
  view_ = std::clamp(degrees, 0.0, 89.0);
  is_old_ = true;
  compute();
}

void LobeView::set_with_cosine(bool with_cosine) {
  with_cosine_ = with_cosine;
  is_old_ = true;
  compute();
}

void LobeView::set_logarithmic(bool is_logarithmic) {
  is_logarithmic_ = is_logarithmic;
  is_old_ = true;
  compute();
}

void LobeView::compute() {
  if (!brdf_) {
    job_.stop();
    mesh_ = std::make_shared<const plot::LobeMesh>();
    return draw();
  }
  if (!isVisible() || !is_old_) return;
  is_old_ = false;
  const plot::LobeStyle style = {plot::Channel::Luminance, with_cosine_, is_logarithmic_};
  job_.start(
      [brdf = brdf_, u = plot::direction_at(-view_), style](const StopFlag& stop) {
        return plot::lobe_mesh(*brdf, u, style, {}, [&] { return stop.is_set(); });
      },
      [this](plot::LobeMesh mesh) {
        mesh_ = std::make_shared<const plot::LobeMesh>(std::move(mesh));
        draw();
        emit updated();
      });
}

LobePicture LobeView::picture() const {
  const Theme theme = theme_of(palette());
  return {mesh_,
          to_clip(),
          eye_direction(azimuth_, elevation_),
          series_colour(theme, 1),
          colours_of(theme).base,
          (QSizeF(size()) * devicePixelRatioF()).toSize()};
}

void LobeView::draw() {
  update();
  if (mesh_->peak <= 0) drawn_ = {};
  if (mesh_->peak <= 0 || !isVisible()) return;
  // Only one image is drawn at a time, so that requests never pile up.
  is_drawn_old_ = is_drawing_;
  if (is_drawing_) return;
  is_drawing_ = true;
  thread_.run([this, picture = picture()](QOpenGLContext* context) {
    if (painter_ == nullptr && context != nullptr) painter_ = std::make_unique<LobePainter>(*context);
    const QImage image = painter_ != nullptr ? painter_->paint(picture) : QImage();
    QMetaObject::invokeMethod(
        this,
        [this, image, to_clip = picture.to_clip] {
          is_drawing_ = false;
          drawn_ = mesh_->peak > 0 ? image : QImage();
          drawn_to_clip_ = to_clip;
          update();
          if (is_drawn_old_) draw();
        },
        Qt::QueuedConnection);
  });
}

QMatrix4x4 LobeView::to_clip() const {
  QMatrix4x4 matrix;
  const float aspect = static_cast<float>(width()) / static_cast<float>(std::max(1, height()));
  // Fits the disc and the lobe over it, for either aspect ratio.
  const float half = 1.15F * static_cast<float>(zoom_) / std::min(1.0F, aspect);
  matrix.ortho(-half * aspect, half * aspect, -half, half, -10, 10);
  matrix.lookAt(eye_direction(azimuth_, elevation_) + QVector3D(0, 0, 0.35F), QVector3D(0, 0, 0.35F),
                {0, 0, 1});
  return matrix;
}

void LobeView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), colours_of(theme_of(palette())).base);
  if (!drawn_.isNull()) painter.drawImage(rect(), drawn_);
  // The annotations rotate with the lobe.
  paint_over(painter, drawn_.isNull() ? to_clip() : drawn_to_clip_);
}

QPointF LobeView::place_of(const Vec3f& point, const QMatrix4x4& matrix) const {
  const QVector3D clip = matrix.map(QVector3D(point.x, point.y, point.z));
  return {0.5 * (1 + clip.x()) * width(), 0.5 * (1 - clip.y()) * height()};
}

void LobeView::paint_over(QPainter& painter, const QMatrix4x4& matrix) const {
  const ThemeColours colours = colours_of(theme_of(palette()));
  const Theme theme = theme_of(palette());
  painter.setRenderHint(QPainter::Antialiasing);
  if (!brdf_) {
    painter.setPen(colours.faint_text);
    painter.drawText(rect().adjusted(Grid, Grid, -Grid, -Grid), Qt::AlignCenter | Qt::TextWordWrap, hint_);
    return;
  }
  QFont font = this->font();
  font.setPixelSize(11);
  painter.setFont(font);
  QPolygonF rim;
  for (int degrees = 0; degrees <= 360; degrees += 3) {
    const double phi = degrees * std::numbers::pi / 180;
    rim << place_of(Vec3f(static_cast<float>(std::cos(phi)), static_cast<float>(std::sin(phi)), 0), matrix);
  }
  painter.setPen(QPen(colours.line, 1));
  painter.drawPolyline(rim);
  const Vec3f u = plot::direction_at(-view_);
  const Vec3f r = plot::direction_at(view_);
  const auto line = [&](const Vec3f& direction, int series, Qt::PenStyle style, const QString& name) {
    const QPointF end = place_of(direction, matrix);
    painter.setPen(QPen(series_colour(theme, series), 1.5, style));
    painter.drawLine(place_of(Vec3f(0), matrix), end);
    const QRectF place(end.x() - 30, end.y() - (end.y() < 16 ? 0 : 16), 60, 14);
    QColor plate = colours.base;  // text would be unreadable on the lobe's colour
    plate.setAlphaF(0.8F);
    painter.fillRect(painter.boundingRect(place, Qt::AlignCenter, name), plate);
    painter.drawText(place, Qt::AlignCenter, name);
  };
  line(u, 0, Qt::SolidLine, tr("view"));
  line(r, 3, Qt::DashLine, tr("specular"));
  line((u + r).normalized(), 2, Qt::DotLine, tr("half"));
  QString words = tr("%1: maximum %2 1/sr, view %3\u00b0")
                      .arg(with_cosine_ ? "f cos" : "f", number_text(mesh_->peak), number_text(view_));
  if (mesh_->specular > 0) words += tr(", specular part %1").arg(number_text(mesh_->specular));
  painter.setPen(colours.faint_text);
  painter.drawText(rect().adjusted(Grid, 0, -Grid, -Grid / 2), Qt::AlignBottom | Qt::AlignLeft, words);
  if (hasFocus()) {
    painter.setPen(QPen(colours.accent, 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void LobeView::turn(double azimuth, double elevation) {
  azimuth_ = std::remainder(azimuth_ + azimuth, 360);
  elevation_ = std::clamp(elevation_ + elevation, -10.0, 89.9);
  draw();
}

void LobeView::resizeEvent(QResizeEvent*) { draw(); }

void LobeView::showEvent(QShowEvent*) {
  compute();
  draw();
}

void LobeView::mousePressEvent(QMouseEvent* event) { grabbed_at_ = event->position(); }

void LobeView::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton)) return;
  const QPointF moved = event->position() - grabbed_at_;
  grabbed_at_ = event->position();
  turn(-0.6 * moved.x(), 0.6 * moved.y());
}

void LobeView::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) return event->ignore();
  zoom_ = std::clamp(zoom_ * std::exp2(-event->angleDelta().y() / 480.0), 0.1, 4.0);
  draw();
}

void LobeView::keyPressEvent(QKeyEvent* event) {
  constexpr double Step = 5;
  if (event->key() == Qt::Key_PageUp) return set_view(view_ + Step);
  if (event->key() == Qt::Key_PageDown) return set_view(view_ - Step);
  const QPoint way = arrow_way(event->key());
  if (way.isNull()) return QWidget::keyPressEvent(event);
  turn(Step * way.x(), Step * way.y());
}

void LobeView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) draw();
  QWidget::changeEvent(event);
}

}  // namespace editor
