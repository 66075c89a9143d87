#include "editor/image/image_pane.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "editor/appearance/theme.h"
#include "editor/controls/gesture.h"

namespace editor {
namespace {

constexpr double WipeReach = 6;  ///< from the line, to take hold of it
constexpr double KeyStep = 8.0 * Grid;
constexpr double ZoomOfANotch = 1.4142135623730951;

int floor_of(double value) { return static_cast<int>(std::floor(value)); }
int ceil_of(double value) { return static_cast<int>(std::ceil(value)); }

}  // namespace

ImagePane::ImagePane(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(20 * Grid, 12 * Grid);
  setAccessibleName(tr("Image"));
  setAccessibleDescription(tr("Arrow keys move the image; [ and ] move the line between two images."));
}

void ImagePane::set_image(SharedImage image, const QString& name) {
  const bool has_new_size =
      !image_ || !image || image_->width != image->width || image_->height != image->height;
  image_ = std::move(image);
  image_name_ = name;
  if (has_new_size) fit();
  tell_pixel();
  update();
}

void ImagePane::set_reference(SharedImage reference, const QString& name) {
  reference_ = std::move(reference);
  reference_name_ = name;
  update();
}

void ImagePane::set_settings(const ScreenSettings& settings) {
  if (settings == settings_) return;
  settings_ = settings;
  update();
}

void ImagePane::set_arrangement(Arrangement arrangement) {
  if (arrangement == arrangement_) return;
  const bool changes_view =
      (arrangement == Arrangement::SideBySide) != (arrangement_ == Arrangement::SideBySide);
  arrangement_ = arrangement;
  if (fits_ && changes_view) fit();
  update_cursor();
  update();
}

void ImagePane::set_hint(const QString& hint) {
  hint_ = hint;
  update();
}

// Geometry

double ImagePane::scale() const { return zoom_ / devicePixelRatioF(); }

QSizeF ImagePane::image_size() const { return image_ ? QSizeF(image_->width, image_->height) : QSizeF(); }

bool ImagePane::shows_two_by(Arrangement arrangement) const {
  return image_ && reference_ && arrangement_ == arrangement;
}

QRectF ImagePane::left_view() const {
  if (!shows_two_by(Arrangement::SideBySide)) return rect();
  return {0, 0, std::floor(width() / 2.0) - 1, double(height())};
}

QRectF ImagePane::right_view() const {
  if (!shows_two_by(Arrangement::SideBySide)) return rect();
  const double left = std::floor(width() / 2.0) + 1;
  return {left, 0, width() - left, double(height())};
}

std::optional<QPoint> ImagePane::pixel_at(const QPointF& place) const {
  if (!image_ || !rect().contains(place.toPoint())) return std::nullopt;
  const QRectF view = right_view().contains(place) ? right_view() : left_view();
  const QPointF inside = (place - view.topLeft() - origin_) / scale();
  const QPoint pixel(floor_of(inside.x()), floor_of(inside.y()));
  if (!QRect(0, 0, image_->width, image_->height).contains(pixel)) return std::nullopt;
  return pixel;
}

QPointF ImagePane::place_of(const QPoint& pixel) const {
  return left_view().topLeft() + origin_ + (QPointF(pixel) + QPointF(0.5, 0.5)) * scale();
}

bool ImagePane::is_near_wipe(const QPointF& place) const {
  return shows_two_by(Arrangement::Wipe) && std::abs(place.x() - wipe_ * width()) < WipeReach;
}

// Pan and zoom

void ImagePane::fit() {
  fits_ = true;
  if (!image_ || width() <= 0 || height() <= 0) return;
  const QSizeF view = left_view().size();
  const QSizeF size = image_size();
  const double ratio = devicePixelRatioF();
  const double whole = ratio * std::min(view.width() / size.width(), view.height() / size.height());
  // Zoom is rounded down to an integer, so that all pixels have the same size.
  set_zoom(whole > 1 ? std::floor(whole) : whole);
  const QSizeF left = view - size * scale();
  origin_ = QPointF(std::floor(left.width() / 2), std::floor(left.height() / 2));
  tell_pixel();
  update();
}

void ImagePane::show_actual_size() { zoom_by(1 / zoom_, pointer_.value_or(QPointF(rect().center()))); }

void ImagePane::zoom_by(double factor, const QPointF& about) {
  if (!image_) return;
  fits_ = false;
  const QRectF view = right_view().contains(about) ? right_view() : left_view();
  const QPointF fixed = (about - view.topLeft() - origin_) / scale();
  set_zoom(std::clamp(zoom_ * factor, LeastZoom, LargestZoom));
  origin_ = about - view.topLeft() - fixed * scale();
  keep_in_view();
  tell_pixel();
  update();
}

void ImagePane::zoom_by(double factor) { zoom_by(factor, left_view().center()); }

void ImagePane::move_by(const QPointF& offset) {
  if (!image_) return;
  fits_ = false;
  origin_ += offset;
  keep_in_view();
  tell_pixel();
  update();
}

void ImagePane::set_zoom(double zoom) {
  if (zoom == zoom_) return;
  zoom_ = zoom;
  emit zoomed(zoom_);
}

/// Keeps a strip of the image in the view.
void ImagePane::keep_in_view() {
  constexpr double Strip = 4.0 * Grid;
  const QSizeF size = image_size() * scale();
  const QSizeF view = left_view().size();
  origin_.setX(
      std::clamp(origin_.x(), std::min(0.0, Strip - size.width()), std::max(0.0, view.width() - Strip)));
  origin_.setY(
      std::clamp(origin_.y(), std::min(0.0, Strip - size.height()), std::max(0.0, view.height() - Strip)));
}

void ImagePane::set_wipe(double share) {
  const double wipe = std::clamp(share, 0.0, 1.0);
  if (wipe == wipe_) return;
  wipe_ = wipe;
  update();
}

void ImagePane::tell_pixel() { emit hovered(pointer_ ? pixel_at(*pointer_) : std::nullopt); }

void ImagePane::update_cursor() {
  if (drags_wipe_ || (pointer_ && is_near_wipe(*pointer_))) {
    setCursor(Qt::SplitHCursor);
  } else if (drag_from_) {
    setCursor(Qt::ClosedHandCursor);
  } else {
    unsetCursor();
  }
}

// Painting

void ImagePane::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColours colours = colours_of(theme_of(palette()));
  painter.fillRect(rect(), colours.base);
  const bool shows_reference = arrangement_ == Arrangement::Reference && reference_;
  const SharedImage& first = shows_reference ? reference_ : image_;
  if (!first) return draw_hint(painter);
  QRectF clip = left_view();
  const bool has_wipe = shows_two_by(Arrangement::Wipe);
  if (has_wipe) clip.setWidth(std::round(wipe_ * width()));
  draw(painter, first, left_view(), clip, converted_[0]);
  if (has_wipe || shows_two_by(Arrangement::SideBySide)) {
    QRectF right = right_view();
    if (has_wipe) right.setLeft(clip.right());
    draw(painter, reference_, right_view(), right, converted_[1]);
    painter.setClipping(false);
    if (has_wipe) draw_wipe(painter);
    if (!has_wipe) painter.fillRect(QRectF(left_view().right(), 0, 2, height()), colours.line);
    draw_name(painter, reference_name_, right_view(), Qt::AlignRight);
  }
  painter.setClipping(false);
  draw_name(painter, shows_reference ? reference_name_ : image_name_, left_view(), Qt::AlignLeft);
  if (hasFocus()) {
    painter.setPen(colours.accent);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

void ImagePane::draw(QPainter& painter, const SharedImage& image, const QRectF& view, const QRectF& clip,
                     Converted& cache) {
  const QPointF corner = view.topLeft() + origin_;
  const QRectF seen = clip.translated(-corner);
  const int block = std::max(1, floor_of(1 / zoom_));
  const auto aligned = [block](double value) { return floor_of(value / block) * block; };
  QRect part(QPoint(aligned(seen.left() / scale()), aligned(seen.top() / scale())),
             QPoint(ceil_of(seen.right() / scale()), ceil_of(seen.bottom() / scale())));
  part &= QRect(0, 0, image->width, image->height);
  if (part.isEmpty()) return;
  if (cache.image != image || cache.settings != settings_ || cache.part != part || cache.block != block) {
    cache = {image, settings_, part, block, ScreenColours(settings_).convert(*image, part, block)};
  }
  painter.setClipRect(clip);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, zoom_ < 1);
  // The last blocks may extend beyond the image's edge.
  const QSizeF size = QSizeF(cache.colours.size()) * block * scale();
  painter.drawImage(QRectF(corner + QPointF(part.topLeft()) * scale(), size), cache.colours);
  painter.setPen(colours_of(theme_of(palette())).line);
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(
      QRectF(corner, QSizeF(image->width, image->height) * scale()).adjusted(-0.5, -0.5, 0.5, 0.5));
}

void ImagePane::draw_name(QPainter& painter, const QString& name, const QRectF& view, Qt::Alignment side) {
  if (name.isEmpty() || (arrangement_ == Arrangement::Alone && !reference_)) return;
  const ThemeColours colours = colours_of(theme_of(palette()));
  const QString shown =
      painter.fontMetrics().elidedText(name, Qt::ElideMiddle, static_cast<int>(view.width() / 2) - 4 * Grid);
  const QSize size = painter.fontMetrics().size(0, shown) + QSize(2 * Grid, Grid);
  QRectF place(QPointF(view.left() + Grid, view.top() + Grid), size);
  if (side == Qt::AlignRight) place.moveRight(view.right() - Grid);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  QColor behind = colours.window;
  behind.setAlpha(220);
  painter.setBrush(behind);
  painter.drawRoundedRect(place, 4, 4);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(colours.text);
  painter.drawText(place, Qt::AlignCenter, shown);
}

void ImagePane::draw_hint(QPainter& painter) {
  painter.setPen(colours_of(theme_of(palette())).faint_text);
  const int margin = 2 * Grid;
  painter.drawText(rect().adjusted(margin, margin, -margin, -margin), Qt::AlignCenter | Qt::TextWordWrap,
                   hint_);
}

void ImagePane::draw_wipe(QPainter& painter) {
  const ThemeColours colours = colours_of(theme_of(palette()));
  const double x = std::round(wipe_ * width());
  painter.fillRect(QRectF(x - 1, 0, 2, height()), colours.accent);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colours.accent);
  painter.drawRoundedRect(QRectF(x - 4, height() / 2.0 - 2 * Grid, 8, 4 * Grid), 4, 4);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

// Events

void ImagePane::resizeEvent(QResizeEvent*) {
  if (fits_) fit();
}

void ImagePane::wheelEvent(QWheelEvent* event) {
  constexpr double Notch = 120;
  zoom_by(std::pow(ZoomOfANotch, event->angleDelta().y() / Notch), event->position());
  event->accept();
}

void ImagePane::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton) return;
  pointer_ = event->position();
  drags_wipe_ = event->button() == Qt::LeftButton && is_near_wipe(event->position());
  if (!drags_wipe_) drag_from_ = event->position();
  update_cursor();
}

void ImagePane::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->position();
  if (drags_wipe_) {
    set_wipe(event->position().x() / width());
  } else if (drag_from_) {
    const QPointF offset = event->position() - *drag_from_;
    drag_from_ = event->position();
    move_by(offset);
  }
  update_cursor();
  tell_pixel();
}

void ImagePane::mouseReleaseEvent(QMouseEvent*) {
  drags_wipe_ = false;
  drag_from_ = std::nullopt;
  update_cursor();
}

void ImagePane::mouseDoubleClickEvent(QMouseEvent* event) {
  if (fits_) {
    zoom_by(1 / zoom_, event->position());
  } else {
    fit();
  }
}

void ImagePane::leaveEvent(QEvent*) {
  pointer_ = std::nullopt;
  tell_pixel();
}

void ImagePane::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_BracketLeft) return set_wipe(wipe_ - 0.05);
  if (event->key() == Qt::Key_BracketRight) return set_wipe(wipe_ + 0.05);
  const QPoint way = arrow_way(event->key());
  if (way.isNull()) return QWidget::keyPressEvent(event);
  move_by(KeyStep * QPointF(-way.x(), way.y()));
}

}  // namespace editor
