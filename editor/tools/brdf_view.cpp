#include "editor/tools/brdf_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "editor/appearance/theme.h"
#include "editor/controls/gesture.h"
#include "editor/view/view_camera.h"

namespace editor {
namespace {

using reflectance::Vec3f;

constexpr double NearSplit = 5;     // device-independent pixels
constexpr double ArrowPixels = 10;  // that an arrow key turns the object by
constexpr double ArrowDegrees = 5;  // and the light

}  // namespace

BrdfView::BrdfView(const GraphicsDriver& driver, QWidget* parent) : QWidget(parent), renderer_(driver) {
  setAccessibleName(tr("Object with the BRDF"));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(40 * Grid, 24 * Grid);
  set_tool(Tool::Turn);
  clock_.start();
  connect(&renderer_, &BrdfRenderer::drawn, this, &BrdfView::take);
  connect(&renderer_, &BrdfRenderer::probed, this, &BrdfView::probed);
  connect(&renderer_, &BrdfRenderer::failed, this, &BrdfView::failed);
}

QSize BrdfView::sizeHint() const { return {104 * Grid, 72 * Grid}; }

void BrdfView::set_tool(Tool tool) {
  tool_ = tool;
  setToolTip(tool == Tool::Turn
                 ? tr("Drag to turn the object, with the right button to move the light; wheel: distance; + "
                      "and -: exposure")
                 : tr("Drag the highlight to move the light, with the right button to turn the object; arrow "
                      "keys move the light, too"));
}

void BrdfView::show_scene(const BrdfScene& scene) {
  scene_ = scene;
  hint_.clear();
  request();
}

void BrdfView::show_hint(const QString& hint) {
  scene_.object.reset();
  image_ = {};
  hint_ = hint;
  update();
}

void BrdfView::request() {
  if (!scene_.object || !isVisible()) return;
  const double ratio = devicePixelRatioF();
  scene_.size = QSize(std::max(1, static_cast<int>(std::lround(width() * ratio))),
                      std::max(1, static_cast<int>(std::lround(height() * ratio))));
  const ThemeColours colours = colours_of(theme_of(palette()));
  scene_.background_top = colours.base;
  scene_.background_bottom = colours.base;
  requested_ = renderer_.show(scene_);
}

bool BrdfView::is_busy() const {
  return scene_.object && isVisible() && (image_.number != requested_ || !image_.is_done());
}

void BrdfView::take(const BrdfImage& image) {
  if (!scene_.object) return;
  image_ = image;
  if (image.passes == 0) {
    const qint64 now = clock_.elapsed();
    drafts_.push_back(now);
    while (drafts_.front() < now - 1000) drafts_.pop_front();
  }
  update();
  emit drawn();
}

double BrdfView::frames_per_second() const {
  if (drafts_.size() < 3 || clock_.elapsed() - drafts_.back() > 400) return 0;
  const double span = static_cast<double>(drafts_.back() - drafts_.front());
  return span > 0 ? 1000 * static_cast<double>(drafts_.size() - 1) / span : 0;
}

void BrdfView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColours colours = colours_of(theme_of(palette()));
  painter.fillRect(rect(), colours.base);
  if (!scene_.object) {
    painter.setPen(colours.faint_text);
    painter.drawText(rect().adjusted(4 * Grid, 0, -4 * Grid, 0), Qt::AlignCenter | Qt::TextWordWrap, hint_);
  } else if (!image_.image.isNull()) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(rect()), image_.image);
    const int split = scene_.split_column(width());
    if (split > 0 && split < width()) {
      const QColor line = colours.accent;
      painter.setPen(QPen(line, 1));
      painter.drawLine(split, 0, split, height());
      painter.setPen(colours.text);
      painter.drawText(QRect(split - 5 * Grid, Grid, 4 * Grid, 3 * Grid), Qt::AlignRight | Qt::AlignTop, "A");
      painter.drawText(QRect(split + Grid, Grid, 4 * Grid, 3 * Grid), Qt::AlignLeft | Qt::AlignTop, "B");
    }
  }
  if (hasFocus()) {
    painter.setPen(QPen(colours.accent, 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void BrdfView::resizeEvent(QResizeEvent*) { request(); }
void BrdfView::showEvent(QShowEvent*) { request(); }

void BrdfView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) request();
  QWidget::changeEvent(event);
}

QPoint BrdfView::pixel_at(const QPointF& position) const {
  const QPointF device = position * devicePixelRatioF();
  return {static_cast<int>(std::floor(device.x())), static_cast<int>(std::floor(device.y()))};
}

bool BrdfView::is_near_split(const QPointF& position) const {
  const double split = scene_.split * width();
  return scene_.object && split > 0 && split < width() && std::abs(position.x() - split) <= NearSplit;
}

/// The direction from which a light's reflection is seen there. Beside the object, the normal is that of a
/// sphere about it.
Vec3f BrdfView::light_at(const QPointF& position) const {
  const double aspect = static_cast<double>(width()) / height();
  const ViewCamera camera(scene_.view);
  const grf::Vec2d place(position.x() / width() * 2 - 1, 1 - position.y() / height() * 2);
  const Vec3f to_eye = -Vec3f(camera.ray(place, aspect).direction.normalized());
  Vec3f normal(0);
  const QPoint pixel = pixel_at(position);
  const bool is_current = image_.normals && image_.normals->size == scene_.size;
  if (is_current && QRect({0, 0}, scene_.size).contains(pixel))
    normal =
        image_.normals
            ->normals[static_cast<std::size_t>(pixel.y()) * static_cast<std::size_t>(scene_.size.width()) +
                      static_cast<std::size_t>(pixel.x())];
  if (normal == Vec3f(0)) {
    const double radius = 0.7;
    double x = place.x * std::max(aspect, 1.0) / radius;
    double y = place.y / std::min(aspect, 1.0) / radius;
    const double length = std::hypot(x, y);
    if (length > 1) {
      x /= length;
      y /= length;
    }
    normal = Vec3f(camera.right() * x + camera.up() * y -
                   camera.forward() * std::sqrt(std::max(0.0, 1 - x * x - y * y)))
                 .normalized();
  }
  return reflectance::reflected(to_eye, normal);
}

void BrdfView::mousePressEvent(QMouseEvent* event) {
  grabbed_at_ = event->position();
  const bool is_left = event->button() == Qt::LeftButton;
  if (!is_left && event->button() != Qt::RightButton) return;
  if (is_left && is_near_split(event->position())) {
    drag_ = Drag::Split;
  } else {
    drag_ = is_left == (tool_ == Tool::Light) ? Drag::Light : Drag::Turn;
  }
  if (drag_ == Drag::Light) drag(event->position(), false);
}

void BrdfView::drag(const QPointF& position, bool is_done) {
  const QPointF by = position - grabbed_at_;
  grabbed_at_ = position;
  if (drag_ == Drag::Turn) emit turned(by, is_done);
  if (drag_ == Drag::Light) emit light_moved(light_at(position), is_done);
  if (drag_ == Drag::Split) emit split_moved(std::clamp(position.x() / width(), 0.0, 1.0), is_done);
}

void BrdfView::mouseMoveEvent(QMouseEvent* event) {
  if (drag_ != Drag::None && event->buttons() != Qt::NoButton) return drag(event->position(), false);
  setCursor(is_near_split(event->position()) ? Qt::SplitHCursor : Qt::ArrowCursor);
  renderer_.probe(pixel_at(event->position()));
}

void BrdfView::mouseReleaseEvent(QMouseEvent* event) {
  if (drag_ == Drag::None) return;
  drag(event->position(), true);
  drag_ = Drag::None;
}

void BrdfView::leaveEvent(QEvent*) { emit pointer_left(); }

void BrdfView::wheelEvent(QWheelEvent* event) {
  emit zoomed(std::pow(0.9, event->angleDelta().y() / 120.0));
  event->accept();
}

void BrdfView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Plus) return emit exposed(0.5);
  if (event->key() == Qt::Key_Minus) return emit exposed(-0.5);
  if (event->key() == Qt::Key_PageUp) return emit zoomed(0.9);
  if (event->key() == Qt::Key_PageDown) return emit zoomed(1 / 0.9);
  const QPointF way = arrow_way(event->key());
  if (way.isNull()) return QWidget::keyPressEvent(event);
  // As for other views, shift is for the other tool.
  const bool is_light = (tool_ == Tool::Light) != event->modifiers().testFlag(Qt::ShiftModifier);
  if (is_light) return emit light_turned(way * ArrowDegrees);
  emit turned(QPointF(way.x(), -way.y()) * ArrowPixels, true);
}

}  // namespace editor
