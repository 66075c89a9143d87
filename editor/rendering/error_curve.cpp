#include "editor/rendering/error_curve.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "editor/appearance/theme.h"
#include "editor/rendering/render_report.h"

namespace editor {

ErrorCurve::ErrorCurve(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Estimated error over time"));
  setToolTip(
      tr("Estimated relative error of the image (square root of relMSE, in percent, logarithmic) over "
         "the seconds of rendering. The dashed line is the target error"));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
}

void ErrorCurve::clear() {
  points_.clear();
  update();
}

void ErrorCurve::add(double seconds, double error) {
  if (!(error > 0)) return;
  points_.emplace_back(seconds, error);
  update();
}

void ErrorCurve::set_target(std::optional<double> error) {
  target_ = error;
  update();
}

QSize ErrorCurve::sizeHint() const { return {28 * Grid, 16 * Grid}; }
QSize ErrorCurve::minimumSizeHint() const { return {20 * Grid, 8 * Grid}; }

/// Half a decade at least, so that a curve that has just begun is no noise.
ErrorCurve::Range ErrorCurve::error_range() const {
  Range range = {points_.front().y(), points_.front().y()};
  for (const QPointF& point : points_) {
    range.least = std::min(range.least, point.y());
    range.most = std::max(range.most, point.y());
  }
  if (target_) range.least = std::min(range.least, *target_);
  range.least = std::min(range.least, range.most / 3);
  return {range.least / 1.15, range.most * 1.15};
}

QPointF ErrorCurve::place(const QRectF& area, const Range& errors, double seconds, double error) const {
  const double along = points_.back().x() > 0 ? seconds / points_.back().x() : 0;
  const double up = std::log(error / errors.least) / std::log(errors.most / errors.least);
  return {area.left() + along * area.width(), area.bottom() - up * area.height()};
}

void ErrorCurve::draw_frame(QPainter& painter, const QRectF& area, const Range& errors) const {
  const ThemeColours colours = colours_of(theme_of(palette()));
  const double line = painter.fontMetrics().height();
  painter.setPen(colours.line);
  painter.drawLine(area.bottomLeft(), area.bottomRight());
  painter.drawLine(area.topLeft(), area.bottomLeft());
  painter.setPen(colours.faint_text);
  const auto label = [&](double error) {
    const QPointF at = place(area, errors, 0, error);
    painter.drawText(QRectF(0, at.y() - line / 2, area.left() - Grid / 2, line),
                     Qt::AlignRight | Qt::AlignVCenter, percent_text(error));
  };
  label(errors.most / 1.15);
  label(errors.least * 1.15);
  const QRectF below(area.left(), area.bottom() + 2, area.width(), line);
  painter.drawText(below, Qt::AlignLeft, "0");
  painter.drawText(below, Qt::AlignRight, duration_text(points_.back().x()));
  painter.drawText(QRectF(area.left(), Grid / 2, area.width(), line), Qt::AlignRight, tr("Estimated error"));
}

void ErrorCurve::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme theme = theme_of(palette());
  const ThemeColours colours = colours_of(theme);
  painter.fillRect(rect(), colours.base);
  QFont small = font();
  small.setPixelSize(11);
  painter.setFont(small);
  if (points_.empty()) {
    painter.setPen(colours.faint_text);
    painter.drawText(rect().adjusted(Grid, 0, -Grid, 0), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("The estimated error of a render appears here"));
    return;
  }
  const double line = painter.fontMetrics().height();
  const QRectF area = QRectF(rect()).adjusted(6.5 * Grid, line + Grid, -Grid, -line - Grid / 2);
  const Range errors = error_range();
  draw_frame(painter, area, errors);
  if (target_) {
    painter.setPen(QPen(colours.accent, 1, Qt::DashLine));
    painter.drawLine(place(area, errors, 0, *target_), place(area, errors, points_.back().x(), *target_));
  }
  QPainterPath path(place(area, errors, points_.front().x(), points_.front().y()));
  for (const QPointF& point : points_) path.lineTo(place(area, errors, point.x(), point.y()));
  painter.setPen(QPen(series_colour(theme, 1), 1.5));
  painter.drawPath(path);
  painter.setBrush(series_colour(theme, 1));
  painter.drawEllipse(place(area, errors, points_.back().x(), points_.back().y()), 2, 2);
}

}  // namespace editor
