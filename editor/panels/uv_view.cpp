#include "editor/panels/uv_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/appearance/theme.h"
#include "editor/controls/gesture.h"

namespace editor {
namespace {

constexpr int LargestTexture = 2048;  ///< pixels per side
constexpr double ZoomStep = 1.25;
/// Limits of the height of the image in the view, in pixels; a smaller image is not repeated.
constexpr double SmallestUnit = 16;
constexpr double LargestUnit = 1e6;
constexpr double KeyStep = 0.01;
constexpr double LargeKeyStep = 0.1;

QRectF bounds_of_outlines(const QVector<QPolygonF>& outlines) {
  QRectF bounds;
  for (const QPolygonF& outline : outlines) bounds |= outline.boundingRect();
  return bounds;
}

}  // namespace

UvView::UvView(QWidget* parent) : QWidget(parent), image_(LargestTexture), settling_(new QTimer(this)) {
  setAccessibleName(tr("Texture coordinates"));
  setToolTip(tr(
      "The selected faces over their image; a drag or the arrows move their texture coordinates, the wheel "
      "zooms, the middle button pans, 0 fits"));
  setFocusPolicy(Qt::StrongFocus);
  settling_->setSingleShot(true);
  settling_->setInterval(SettlingMilliseconds);
  connect(settling_, &QTimer::timeout, this, [this] {
    nudged_ = {};
    emit moved();
  });
  connect(&image_, &TextureImage::changed, this, [this] {
    scaled_ = {};
    refit();
    update();
  });
}

QSize UvView::sizeHint() const { return {40 * Grid, 36 * Grid}; }

QSize UvView::minimumSizeHint() const { return {20 * Grid, 16 * Grid}; }

void UvView::show_outlines(QVector<QPolygonF> outlines) {
  outlines_ = std::move(outlines);
  shown_transform_ = {};
  update();
}

void UvView::show_transform(const QTransform& transform) {
  shown_transform_ = transform;
  update();
}

void UvView::cancel_gesture() {
  move_from_.reset();
  nudged_ = {};
  settling_->stop();
}

// Pan and zoom

/// The proportions of the image, with a height of 1.
QSizeF UvView::unit() const {
  const QSize size = image_.image().size();
  return {size.isEmpty() ? 1 : static_cast<double>(size.width()) / size.height(), 1};
}

/// What a fitted view shows, in texture coordinates.
QRectF UvView::contents() const { return QRectF(0, 0, 1, 1) | bounds_of_outlines(outlines_); }

void UvView::fit() {
  fits_ = true;
  const QRectF inside = QRectF(rect()).adjusted(Grid, Grid, -Grid, -Grid);
  const QRectF shown = contents();
  const QSizeF size(shown.width() * unit().width(), shown.height());
  if (inside.width() <= 0 || inside.height() <= 0) return;
  const double scale = std::min(inside.width() / size.width(), inside.height() / size.height());
  const double x_scale = scale * unit().width();
  to_pixels_ = QTransform(x_scale, 0, 0, -scale, inside.center().x() - shown.center().x() * x_scale,
                          inside.center().y() + shown.center().y() * scale);
  update();
}

void UvView::refit() {
  if (fits_) fit();
}

void UvView::zoom_by(double factor, const QPointF& about) {
  fits_ = false;
  const double height = -to_pixels_.m22();
  // A fitted view may be beyond the limits.
  const double possible =
      std::clamp(height * factor, std::min(height, SmallestUnit), std::max(height, LargestUnit)) / height;
  to_pixels_ = to_pixels_ * QTransform::fromTranslate(-about.x(), -about.y()) *
               QTransform::fromScale(possible, possible) * QTransform::fromTranslate(about.x(), about.y());
  update();
}

void UvView::resizeEvent(QResizeEvent*) { refit(); }

void UvView::wheelEvent(QWheelEvent* event) {
  constexpr double Notch = 120;
  zoom_by(std::pow(ZoomStep, event->angleDelta().y() / Notch), event->position());
  event->accept();
}

// Gestures

void UvView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !outlines_.isEmpty()) move_from_ = uv_at(event->position());
  if (event->button() == Qt::MiddleButton) pan_from_ = event->position();
}

void UvView::mouseMoveEvent(QMouseEvent* event) {
  if (pan_from_) {
    fits_ = false;
    const QPointF offset = event->position() - std::exchange(*pan_from_, event->position());
    to_pixels_ = to_pixels_ * QTransform::fromTranslate(offset.x(), offset.y());
    update();
  } else if (move_from_) {
    emit moving(uv_at(event->position()) - *move_from_);
  }
}

void UvView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) pan_from_.reset();
  if (event->button() != Qt::LeftButton || !move_from_) return;
  move_from_.reset();
  emit moved();
}

void UvView::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? LargeKeyStep : KeyStep;
  const QPoint way = arrow_way(event->key());
  if (!way.isNull()) return nudge(QPointF(way) * step);
  switch (event->key()) {
    case Qt::Key_Plus:
      return zoom_by(ZoomStep, rect().center());
    case Qt::Key_Minus:
      return zoom_by(1 / ZoomStep, rect().center());
    case Qt::Key_0:
      return fit();
    default:
      return QWidget::keyPressEvent(event);
  }
}

void UvView::nudge(const QPointF& offset) {
  if (outlines_.isEmpty()) return;
  nudged_ += offset;
  emit moving(nudged_);
  settling_->start();
}

// Drawing

const QPixmap& UvView::scaled_image(const QSize& device_size) {
  if (scaled_.size() != device_size) {
    scaled_ = QPixmap::fromImage(
        image_.image().scaled(device_size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  }
  return scaled_;
}

void UvView::draw_image(QPainter& painter) {
  constexpr double FaintOpacity = 0.25;
  const QRectF whole(0, 0, 1, 1);
  const QRectF visible = to_pixels_.inverted().mapRect(QRectF(rect()));
  const QRectF seen = -to_pixels_.m22() < SmallestUnit ? whole & visible : visible;
  const QSizeF tile = to_pixels_.mapRect(whole).size();
  const QSize device_size = (tile * devicePixelRatioF()).toSize().expandedTo({1, 1});
  // Enlarged images have few tiles in the view, and would need much memory.
  const bool is_enlarged = std::max(device_size.width(), device_size.height()) > LargestTexture;
  const QPointF first(std::floor(seen.left()), std::floor(seen.top()));
  for (int row = 0; first.y() + row < seen.bottom(); ++row) {
    for (int column = 0; first.x() + column < seen.right(); ++column) {
      const double u = first.x() + column;
      const double v = first.y() + row;
      painter.setOpacity(u == 0 && v == 0 ? 1 : FaintOpacity);
      const QRectF place = to_pixels_.mapRect(QRectF(u, v, 1, 1));
      if (is_enlarged) {
        painter.drawImage(place, image_.image());
      } else {
        painter.drawPixmap(place, scaled_image(device_size), QRectF({0, 0}, QSizeF(device_size)));
      }
    }
  }
  painter.setOpacity(1);
}

void UvView::draw_borders(QPainter& painter) {
  const ThemeColours colours = colours_of(theme_of(palette()));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(colours.text);
  painter.drawRect(to_pixels_.mapRect(QRectF(0, 0, 1, 1)));
  if (hasFocus()) {
    painter.setPen(colours.accent);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

void UvView::paintEvent(QPaintEvent*) {
  const ThemeColours colours = colours_of(theme_of(palette()));
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.fillRect(rect(), colours.base);
  if (!image_.image().isNull()) draw_image(painter);
  draw_borders(painter);
  draw_outlines(painter, outlines_, shown_transform_ * to_pixels_, colours);
  if (image_.image().isNull()) {
    painter.setPen(colours.faint_text);
    painter.drawText(rect().adjusted(Grid, Grid, -Grid, -Grid),
                     Qt::AlignBottom | Qt::AlignHCenter | Qt::TextWordWrap, image_.text());
  }
}

}  // namespace editor
