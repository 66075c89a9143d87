#include "editor/brdf/lobe_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "editor/appearance/theme.h"
#include "editor/controls/expression.h"

namespace editor {
namespace {

using reflectance::Vec3f;

const char* const VertexText = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 to_clip;
out vec3 point;
out vec3 direction;
void main() {
  point = position;
  direction = normal;
  gl_Position = to_clip * vec4(position, 1);
}
)";

const char* const FragmentText = R"(#version 330 core
in vec3 point;
in vec3 direction;
uniform vec3 eye;
uniform vec3 colour;
out vec4 result;
void main() {
  float facing = abs(dot(normalize(direction), eye));
  float light = 0.35 + 0.65 * facing;
  result = vec4(colour * light, 1);
}
)";

QSurfaceFormat lobe_format() {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setSamples(4);
  return format;
}

/// Towards the eye.
QVector3D eye_direction(double azimuth, double elevation) {
  const double a = azimuth * std::numbers::pi / 180;
  const double e = elevation * std::numbers::pi / 180;
  return QVector3D(static_cast<float>(std::cos(e) * std::sin(a)),
                   static_cast<float>(-std::cos(e) * std::cos(a)), static_cast<float>(std::sin(e)));
}

}  // namespace

/// Lines and words over the lobe. A widget of its own, since painters in a core profile draw nothing with
/// some versions of Qt.
class LobeView::Overlay : public QWidget {
 public:
  explicit Overlay(LobeView& view) : QWidget(&view), view_(view) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    view_.paint_over(painter);
  }

 private:
  LobeView& view_;
};

LobeView::LobeView(QWidget* parent) : QOpenGLWidget(parent), overlay_(new Overlay(*this)) {
  setFormat(lobe_format());
  setMinimumSize(16 * Grid, 16 * Grid);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName("Lobe of the BRDF");
  setToolTip(
      "The value over all directions of light, in 1/sr. Drag, or use the arrow keys, to look at it from "
      "elsewhere; the wheel zooms; Page Up and Page Down move the view direction by 5 degrees");
}

LobeView::~LobeView() {
  disconnect(context_end_);
  makeCurrent();
  release();
  doneCurrent();
}

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
    mesh_ = {};
    return show_again();
  }
  if (!isVisible() || !is_old_) return;
  is_old_ = false;
  job_.start([brdf = brdf_, view = view_, with_cosine = with_cosine_, is_logarithmic = is_logarithmic_](
                 const StopFlag& stop) { return lobe_mesh(*brdf, view, with_cosine, is_logarithmic, stop); },
             [this](LobeMesh mesh) {
               mesh_ = std::move(mesh);
               needs_upload_ = true;
               show_again();
               emit updated();
             });
}

void LobeView::show_again() {
  update();
  overlay_->update();
}

void LobeView::initializeGL() {
  program_ = std::make_unique<QOpenGLShaderProgram>();
  program_->addShaderFromSourceCode(QOpenGLShader::Vertex, VertexText);
  program_->addShaderFromSourceCode(QOpenGLShader::Fragment, FragmentText);
  program_->link();
  layout_.create();
  vertices_.create();
  indices_.create();
  needs_upload_ = true;
  // The context goes when the widget moves to another window.
  disconnect(context_end_);
  context_end_ = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
    makeCurrent();
    release();
    doneCurrent();
  });
}

void LobeView::release() {
  program_.reset();
  vertices_.destroy();
  indices_.destroy();
  layout_.destroy();
}

void LobeView::upload() {
  needs_upload_ = false;
  std::vector<Vec3f> vectors;
  vectors.reserve(2 * mesh_.positions.size());
  for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
    vectors.push_back(mesh_.positions[i]);
    vectors.push_back(mesh_.normals[i]);
  }
  layout_.bind();
  vertices_.bind();
  vertices_.allocate(vectors.data(), static_cast<int>(vectors.size() * sizeof(Vec3f)));
  indices_.bind();
  indices_.allocate(mesh_.triangles.data(), static_cast<int>(mesh_.triangles.size() * sizeof(std::uint32_t)));
  program_->bind();
  for (int k = 0; k < 2; ++k) {
    program_->enableAttributeArray(k);
    program_->setAttributeBuffer(k, GL_FLOAT, k * static_cast<int>(sizeof(Vec3f)), 3, 2 * sizeof(Vec3f));
  }
  layout_.release();
}

QMatrix4x4 LobeView::to_clip() const {
  QMatrix4x4 matrix;
  const float aspect = static_cast<float>(width()) / static_cast<float>(std::max(1, height()));
  // The disc and the lobe over it, in either shape of window.
  const float half = 1.15F * static_cast<float>(zoom_) / std::min(1.0F, aspect);
  matrix.ortho(-half * aspect, half * aspect, -half, half, -10, 10);
  matrix.lookAt(eye_direction(azimuth_, elevation_) + QVector3D(0, 0, 0.35F), QVector3D(0, 0, 0.35F),
                {0, 0, 1});
  return matrix;
}

void LobeView::paintGL() {
  QOpenGLFunctions* gl = context()->functions();
  const ThemeColours colours = colours_of(theme_of(palette()));
  gl->glClearColor(colours.base.redF(), colours.base.greenF(), colours.base.blueF(), 1);
  gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const QMatrix4x4 matrix = to_clip();
  if (mesh_.peak > 0 && program_->isLinked()) {
    if (needs_upload_) upload();
    draw_lobe(matrix);
  }
}

void LobeView::draw_lobe(const QMatrix4x4& matrix) {
  QOpenGLFunctions* gl = context()->functions();
  const QColor colour = series_colour(theme_of(palette()), 1);
  gl->glEnable(GL_DEPTH_TEST);
  program_->bind();
  program_->setUniformValue("to_clip", matrix);
  program_->setUniformValue("eye", eye_direction(azimuth_, elevation_));
  program_->setUniformValue("colour", QVector3D(colour.redF(), colour.greenF(), colour.blueF()));
  layout_.bind();
  gl->glDrawElements(GL_TRIANGLES, static_cast<int>(mesh_.triangles.size()), GL_UNSIGNED_INT, nullptr);
  layout_.release();
  program_->release();
  gl->glDisable(GL_DEPTH_TEST);
}

QPointF LobeView::place_of(const Vec3f& point, const QMatrix4x4& matrix) const {
  const QVector3D clip = matrix.map(QVector3D(point.x, point.y, point.z));
  return {0.5 * (1 + clip.x()) * width(), 0.5 * (1 - clip.y()) * height()};
}

void LobeView::paint_over(QPainter& painter) const {
  const QMatrix4x4 matrix = to_clip();
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
  const Vec3f u = direction_at(-view_);
  const Vec3f r = direction_at(view_);
  const auto line = [&](const Vec3f& direction, int series, Qt::PenStyle style, const QString& name) {
    const QPointF end = place_of(direction, matrix);
    painter.setPen(QPen(series_colour(theme, series), 1.5, style));
    painter.drawLine(place_of(Vec3f(0), matrix), end);
    const QRectF place(end.x() - 30, end.y() - (end.y() < 16 ? 0 : 16), 60, 14);
    QColor plate = colours.base;  // over the lobe its colour would not be read
    plate.setAlphaF(0.8F);
    painter.fillRect(painter.boundingRect(place, Qt::AlignCenter, name), plate);
    painter.drawText(place, Qt::AlignCenter, name);
  };
  line(u, 0, Qt::SolidLine, "view");
  line(r, 3, Qt::DashLine, "mirror");
  line((u + r).normalized(), 2, Qt::DotLine, "half");
  QString words = QString("%1: at most %2 1/sr, view %3\u00b0")
                      .arg(with_cosine_ ? "f cos" : "f", number_text(mesh_.peak), number_text(view_));
  if (mesh_.mirror > 0) words += QString(", mirror part %1").arg(number_text(mesh_.mirror));
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
  show_again();
}

void LobeView::resizeEvent(QResizeEvent* event) {
  QOpenGLWidget::resizeEvent(event);
  overlay_->resize(size());
}

void LobeView::showEvent(QShowEvent* event) {
  QOpenGLWidget::showEvent(event);
  compute();
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
  show_again();
}

void LobeView::keyPressEvent(QKeyEvent* event) {
  constexpr double Step = 5;
  switch (event->key()) {
    case Qt::Key_Left:
      return turn(-Step, 0);
    case Qt::Key_Right:
      return turn(Step, 0);
    case Qt::Key_Up:
      return turn(0, Step);
    case Qt::Key_Down:
      return turn(0, -Step);
    case Qt::Key_PageUp:
      return set_view(view_ + Step);
    case Qt::Key_PageDown:
      return set_view(view_ - Step);
    default:
      QOpenGLWidget::keyPressEvent(event);
  }
}

void LobeView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) show_again();
  QOpenGLWidget::changeEvent(event);
}

}  // namespace editor
