#include "editor/tools/figure_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cstring>

#include "editor/appearance/theme.h"
#include "renderer/plot/svg.h"

namespace editor {
namespace {

QImage image_of(const std::string& svg, double scale) {
  const auto bitmap = plot::to_bitmap(svg, scale);
  if (!bitmap) return {};
  QImage image(bitmap->width, bitmap->height, QImage::Format_RGB32);
  const auto width = static_cast<std::size_t>(bitmap->width);
  for (int y = 0; y < bitmap->height; ++y) {
    std::memcpy(image.scanLine(y), bitmap->pixels.data() + static_cast<std::size_t>(y) * width, 4 * width);
  }
  return image;
}

}  // namespace

FigureView::FigureView(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Figure"));
  setToolTip(
      tr("Point at a part of the figure to read its values; drag it or use the arrow keys to turn it"));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(40 * Grid, 24 * Grid);
}

QSize FigureView::sizeHint() const { return {104 * Grid, 72 * Grid}; }

void FigureView::show_figure(std::string svg, const QSizeF& size) {
  hint_.clear();
  svg_ = std::move(svg);
  size_ = size;
  render();
}

void FigureView::show_hint(const QString& hint) {
  job_.stop();
  hint_ = hint;
  svg_.clear();
  image_ = {};
  update();
}

double FigureView::scale() const {
  if (size_.isEmpty()) return 1;
  return std::min(width() / size_.width(), height() / size_.height());
}

QPointF FigureView::in_figure(const QPointF& position) const {
  const QPointF from_middle = position - QRectF(rect()).center();
  return from_middle / scale() + QPointF(size_.width(), size_.height()) / 2;
}

QPointF FigureView::in_widget(const QPointF& of_figure) const {
  return (of_figure - QPointF(size_.width(), size_.height()) / 2) * scale() + QRectF(rect()).center();
}

void FigureView::render() {
  if (svg_.empty()) return;
  const double ratio = devicePixelRatioF();
  job_.start([svg = svg_, pixels = scale() * ratio](const StopFlag&) { return image_of(svg, pixels); },
             [this, ratio](QImage image) {
               image.setDevicePixelRatio(ratio);
               image_ = std::move(image);
               update();
               emit rendered();
             });
}

void FigureView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColours colours = colours_of(theme_of(palette()));
  painter.fillRect(rect(), colours.base);
  if (!hint_.isEmpty()) {
    painter.setPen(colours.faint_text);
    painter.drawText(rect().adjusted(4 * Grid, 0, -4 * Grid, 0), Qt::AlignCenter | Qt::TextWordWrap, hint_);
  } else if (!image_.isNull()) {
    // Until the picture for a new size is there, the old one is stretched.
    const QSizeF shown = size_ * scale();
    const QPointF corner = QRectF(rect()).center() - QPointF(shown.width(), shown.height()) / 2;
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if ((image_.deviceIndependentSize() - shown).width() < 1)
      painter.drawImage(QPointF(corner.toPoint()), image_);
    else
      painter.drawImage(QRectF(corner, shown), image_);
  }
  if (hasFocus()) {
    painter.setPen(QPen(colours.accent, 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void FigureView::resizeEvent(QResizeEvent*) { render(); }

void FigureView::mousePressEvent(QMouseEvent* event) { grabbed_at_ = event->position(); }

void FigureView::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton)) return emit pointed(in_figure(event->position()));
  const QPointF by = event->position() - grabbed_at_;
  grabbed_at_ = event->position();
  emit turned(by, false);
}

void FigureView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit turned(event->position() - grabbed_at_, true);
}

void FigureView::leaveEvent(QEvent*) { emit pointer_left(); }

void FigureView::keyPressEvent(QKeyEvent* event) {
  constexpr double Step = 8;  // pixels
  switch (event->key()) {
    case Qt::Key_Left:
      return emit turned({-Step, 0}, true);
    case Qt::Key_Right:
      return emit turned({Step, 0}, true);
    case Qt::Key_Up:
      return emit turned({0, -Step}, true);
    case Qt::Key_Down:
      return emit turned({0, Step}, true);
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace editor
