#include "editor/rendering/error_curve.h"

#include <algorithm>

#include <qcustomplot.h>

#include "editor/appearance/theme.h"
#include "editor/charts/chart_painter.h"
#include "editor/controls/form_widgets.h"
#include "renderer/plot/chart.h"

namespace editor {

ErrorCurve::ErrorCurve(QWidget* parent) : QStackedWidget(parent), plot_(new QCustomPlot) {
  plot_->setAccessibleName(tr("Estimated error over time"));
  plot_->setToolTip(
      tr("Estimated relative error of the image (square root of relMSE, in percent, logarithmic) over "
         "the seconds of rendering. The dashed line is the target error"));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
  addWidget(hint_label(tr("The estimated error of a render appears here"), this));
  addWidget(plot_);
}

void ErrorCurve::clear() {
  points_.clear();
  draw();
}

void ErrorCurve::add(double seconds, double error) {
  if (!(error > 0)) return;
  points_.emplace_back(seconds, 100 * error);
  draw();
}

void ErrorCurve::set_target(std::optional<double> error) {
  target_ = error ? std::optional(100 * *error) : std::nullopt;
  draw();
}

QSize ErrorCurve::sizeHint() const { return {28 * Grid, 16 * Grid}; }
QSize ErrorCurve::minimumSizeHint() const { return {20 * Grid, 8 * Grid}; }

void ErrorCurve::draw() {
  setCurrentIndex(points_.empty() ? 0 : 1);
  if (points_.empty()) return;
  const double end = points_.back().x;
  const auto [lowest, highest] = std::ranges::minmax_element(
      points_, [](const plot::Point& a, const plot::Point& b) { return a.y < b.y; });
  // The axis covers half a decade at least, so that a short curve does not look like noise.
  const double least = std::min(target_ ? std::min(lowest->y, *target_) : lowest->y, highest->y / 3);
  plot::Chart chart{{},
                    {tr("seconds").toStdString(), false, 0, end > 0 ? end : 1, 0},
                    {tr("estimated error in %").toStdString(), true, least / 1.15, highest->y * 1.15, 0},
                    {{{}, points_, {}, {}}}};
  if (target_) chart.series.push_back({{}, {{0, *target_}, {chart.x.maximum.value(), *target_}}, {}, "5 3"});
  editor::draw(*plot_, chart);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void ErrorCurve::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) draw();
  QStackedWidget::changeEvent(event);
}

}  // namespace editor
