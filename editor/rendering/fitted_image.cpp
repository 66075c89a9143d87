#include "editor/rendering/fitted_image.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "editor/appearance/theme.h"
#include "renderer/image/srgb.h"

namespace editor {
namespace {

/// Box filter over the pixels that a pixel of a smaller image covers; nearest neighbour for a larger one.
grf::Colour covered(const image::Image& image, int x, int y, const QSize& size) {
  const auto part = [](int place, int count, int count_there) {
    const int begin = static_cast<int>(static_cast<qint64>(place) * count_there / count);
    const int end = static_cast<int>(static_cast<qint64>(place + 1) * count_there / count);
    return std::pair(begin, std::max(end, begin + 1));
  };
  const auto [left, right] = part(x, size.width(), image.width);
  const auto [top, bottom] = part(y, size.height(), image.height);
  grf::Colour sum(0);
  for (int row = top; row < bottom; ++row) {
    for (int column = left; column < right; ++column) sum += image.at(column, row);
  }
  return sum / static_cast<float>((right - left) * (bottom - top));
}

}  // namespace

ScreenSettings error_screen_settings() {
  ScreenSettings settings;
  settings.colouring = Colouring::FalseColour;
  settings.is_radiance = false;
  settings.is_relative_error = true;
  settings.least = 0.001;
  settings.largest = 1;
  return settings;
}

QImage fitted(const image::Image& image, const QSize& pixels, const image::Image* error) {
  const bool has_error = error != nullptr && error->width == image.width && error->height == image.height;
  const ScreenColours false_colours(error_screen_settings());
  const QSize size = QSize(image.width, image.height).scaled(pixels, Qt::KeepAspectRatio).expandedTo({1, 1});
  QImage result(size, QImage::Format_RGB32);
  for (int y = 0; y < size.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(result.scanLine(y));
    for (int x = 0; x < size.width(); ++x) {
      const grf::Colour colour = covered(image, x, y, size);
      line[x] =
          qRgb(image::to_srgb_byte(colour.x), image::to_srgb_byte(colour.y), image::to_srgb_byte(colour.z));
      if (!has_error) continue;
      const grf::Colour there = covered(*error, x, y, size);
      if (std::isfinite(there.x)) line[x] = false_colours(there);
    }
  }
  return result;
}

FittedImage::FittedImage(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Image"));
  setToolTip(tr("The image rendered so far. Click or press Return to open it"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void FittedImage::set_image(std::shared_ptr<const image::Image> image,
                            std::shared_ptr<const image::Image> error) {
  image_ = std::move(image);
  error_ = std::move(error);
  drawn_ = QImage();
  setCursor(image_ ? Qt::PointingHandCursor : Qt::ArrowCursor);
  update();
}

void FittedImage::set_error_shown(bool is_shown) {
  is_error_shown_ = is_shown;
  drawn_ = QImage();
  update();
}

void FittedImage::set_hint(const QString& hint) {
  hint_ = hint;
  update();
}

QSize FittedImage::sizeHint() const { return {36 * Grid, 26 * Grid}; }
QSize FittedImage::minimumSizeHint() const { return {20 * Grid, 12 * Grid}; }

void FittedImage::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColours colours = colours_of(theme_of(palette()));
  painter.fillRect(rect(), colours.base);
  if (image_ && !image_->pixels.empty()) {
    const QSize pixels = size() * devicePixelRatioF();
    const bool fits = drawn_.size().scaled(pixels, Qt::KeepAspectRatio) == drawn_.size();
    if (drawn_.isNull() || !fits) drawn_ = fitted(*image_, pixels, is_error_shown_ ? error_.get() : nullptr);
    drawn_.setDevicePixelRatio(devicePixelRatioF());
    const QSizeF drawn = drawn_.deviceIndependentSize();
    painter.drawImage(QPointF((width() - drawn.width()) / 2, (height() - drawn.height()) / 2), drawn_);
  } else {
    painter.setPen(colours.faint_text);
    painter.drawText(rect().adjusted(Grid, Grid, -Grid, -Grid), Qt::AlignCenter | Qt::TextWordWrap, hint_);
  }
  if (!hasFocus()) return;
  painter.setPen(colours.accent);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void FittedImage::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && image_ && rect().contains(event->pos())) emit activated();
}

void FittedImage::keyPressEvent(QKeyEvent* event) {
  const bool opens = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (opens && image_) return emit activated();
  QWidget::keyPressEvent(event);
}

}  // namespace editor
