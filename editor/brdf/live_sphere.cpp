#include "editor/brdf/live_sphere.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "editor/appearance/theme.h"
#include "editor/controls/gesture.h"

namespace editor {
namespace {

using reflectance::Vec3f;

constexpr int LargestSide = 640;  // in pixels; larger ones are scaled

}  // namespace

LiveSphere::LiveSphere(QWidget* parent, const GraphicsDriver& driver) : QWidget(parent), renderer_(driver) {
  setMinimumSize(16 * Grid, 16 * Grid);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Sphere with the BRDF"));
  setToolTip(tr("Drag the highlight to move the light, or use the arrow keys; + and - change the exposure"));
  scene_.light.normalize();
  connect(&renderer_, &SphereRenderer::shaded, this, [this](const SphereImage& image) {
    image_ = image;
    show_image();
    emit shaded();
  });
  connect(&renderer_, &SphereRenderer::warned, this, &LiveSphere::warned);
}

QSize LiveSphere::sizeHint() const { return {25 * Grid, 25 * Grid}; }

void LiveSphere::set_brdf(SharedBrdf brdf, const QString& hint) {
  scene_.brdf = std::move(brdf);
  hint_ = hint;
  setAccessibleDescription(hint);
  request();
}

void LiveSphere::set_exposure(double stops) {
  exposure_ = stops;
  show_image();
}

void LiveSphere::set_light(const Vec3f& light) {
  scene_.light = light.normalized();
  request();
}

void LiveSphere::set_environment(const std::optional<studies::Environment>& environment) {
  const SphereScene studio;
  if (!environment && scene_.environment.kind == studio.environment.kind) return;
  scene_.environment = environment.value_or(studio.environment);
  scene_.light_strength = environment ? 0 : studio.light_strength;
  request();
}

void LiveSphere::request() {
  if (!scene_.brdf) {
    renderer_.stop();
    image_ = {};
    picture_ = {};
    return update();
  }
  if (!isVisible()) return;
  scene_.side = std::clamp(static_cast<int>(picture_place().width() * devicePixelRatioF()), 32, LargestSide);
  renderer_.request(scene_);
}

void LiveSphere::show_image() {
  if (image_.side > 0) picture_ = displayed(image_, exposure_);
  update();
}

QRectF LiveSphere::picture_place() const {
  const double side = std::min(width(), height());
  return {0.5 * (width() - side), 0.5 * (height() - side), side, side};
}

void LiveSphere::paintEvent(QPaintEvent*) {
  const ThemeColours colours = colours_of(theme_of(palette()));
  QPainter painter(this);
  painter.fillRect(rect(), colours.base);
  if (picture_.isNull()) {
    painter.setPen(colours.faint_text);
    const QRect place = rect().adjusted(Grid, Grid, -Grid, -Grid);
    if (!scene_.brdf) painter.drawText(place, Qt::AlignCenter | Qt::TextWordWrap, hint_);
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(picture_place(), picture_);
  if (hasFocus()) {
    painter.setPen(QPen(colours.accent, 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void LiveSphere::resizeEvent(QResizeEvent*) { request(); }
void LiveSphere::showEvent(QShowEvent*) { request(); }

void LiveSphere::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) move_highlight(event->position());
}

void LiveSphere::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) move_highlight(event->position());
}

void LiveSphere::move_highlight(const QPointF& pointer) {
  const QRectF place = picture_place();
  const int side = static_cast<int>(place.width());
  Vec3f n = sphere_normal(side, pointer.x() - place.x(), pointer.y() - place.y());
  if (n.z < 0) {
    n.z = 0;
    n.normalize();
  }
  // The light direction whose reflection is seen there.
  set_light(reflectance::reflected(Vec3f(0, 0, 1), n));
}

void LiveSphere::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Plus) return set_exposure(exposure_ + 0.5);
  if (event->key() == Qt::Key_Minus) return set_exposure(exposure_ - 0.5);
  const QPoint way = arrow_way(event->key());
  if (way.isNull()) return QWidget::keyPressEvent(event);
  constexpr float Step = 5 * reflectance::Pi / 180;
  const Vec3f& l = scene_.light;
  const float azimuth = std::atan2(l.x, l.z) + Step * static_cast<float>(way.x());
  const float risen = std::asin(std::clamp(l.y, -1.0F, 1.0F)) + Step * static_cast<float>(way.y());
  const float height = std::clamp(risen, -1.55F, 1.55F);
  set_light({std::cos(height) * std::sin(azimuth), std::sin(height), std::cos(height) * std::cos(azimuth)});
}

}  // namespace editor
