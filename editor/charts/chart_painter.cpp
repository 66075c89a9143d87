#include "editor/charts/chart_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <qcustomplot.h>

#include "editor/appearance/theme.h"
#include "editor/controls/expression.h"
#include "editor/controls/text.h"
#include "renderer/plot/chart.h"

namespace editor {
namespace {

QFont small_font(const QCustomPlot& plot) {
  QFont font = plot.font();
  font.setPixelSize(11);
  return font;
}

/// Clears the plot and sets the theme's colours, with the legend under the axes.
ThemeColours prepare(QCustomPlot& plot) {
  const ThemeColours colours = colours_of(theme_of(plot.palette()));
  plot.clearPlottables();
  plot.clearItems();
  plot.setBackground(colours.base);
  for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
    axis->setVisible(true);
    axis->setScaleType(QCPAxis::stLinear);
    axis->setTicker(QSharedPointer<QCPAxisTicker>(new QCPAxisTicker));
    axis->setNumberFormat("gb");
    axis->setNumberPrecision(6);
    axis->setBasePen(QPen(colours.line));
    axis->setTickPen(QPen(colours.line));
    axis->setSubTickPen(Qt::NoPen);
    axis->setTickLabelColor(colours.faint_text);
    axis->setLabelColor(colours.text);
    axis->setLabel("");
    axis->setTicks(true);
    axis->setTickLabels(true);
    axis->setTickLabelFont(small_font(plot));
    axis->setLabelFont(small_font(plot));
    QColor grid = colours.line;
    grid.setAlphaF(0.5F);
    axis->grid()->setPen(QPen(grid, 1, Qt::DotLine));
    axis->grid()->setZeroLinePen(Qt::NoPen);
    axis->grid()->setVisible(true);
  }
  QCPLegend& legend = *plot.legend;
  legend.setVisible(true);
  legend.setBrush(Qt::NoBrush);
  legend.setBorderPen(Qt::NoPen);
  legend.setTextColor(colours.text);
  legend.setFont(small_font(plot));
  legend.setIconSize(Grid * 2, Grid);
  legend.setRowSpacing(0);
  legend.setFillOrder(QCPLegend::foColumnsFirst);
  legend.setWrap(plot.width() < 56 * Grid ? 4 : 8);
  return colours;
}

/// The theme's colour for a series colour of documents.
QColor colour_of(const plot::Series& series, std::size_t index, Theme theme, const ThemeColours& colours) {
  // Indices by position among the series colours.
  constexpr std::array<int, 6> Alike = {4, 0, 2, 5, 1, 3};
  const std::string_view colour = series.colour.empty() ? plot::colour_of_series(index) : series.colour;
  for (std::size_t i = 0; i < Alike.size(); ++i) {
    if (plot::colour_of_series(i) == colour) return series_colour(theme, Alike[i]);
  }
  return colours.text;
}

QPen pen_of(const plot::Series& series, const QColor& colour) {
  QPen pen(colour, series.dashes.empty() ? 1.75 : 1.25);
  pen.setCosmetic(true);
  if (!series.dashes.empty()) {
    QList<qreal> lengths;
    for (const QString& length : text_of(series.dashes).split(' ')) lengths << length.toDouble();
    pen.setDashPattern(lengths);
  }
  return pen;
}

/// Adds a polyline in plot coordinates.
void add_line(QCustomPlot& plot, const QList<QPointF>& places, const QPen& pen, const QString& name = {}) {
  auto* curve = new QCPCurve(plot.xAxis, plot.yAxis);
  for (const QPointF& place : places) curve->addData(place.x(), place.y());
  curve->setPen(pen);
  curve->setName(name);
  if (name.isEmpty()) curve->removeFromLegend();
}

void add_text(QCustomPlot& plot, const QString& text, QPointF place, Qt::Alignment alignment,
              const QColor& colour) {
  auto* item = new QCPItemText(&plot);
  item->setPositionAlignment(alignment);
  item->position->setCoords(place);
  item->setText(text);
  item->setColor(colour);
  item->setFont(small_font(plot));
  item->setPadding({2, 1, 2, 1});
  item->setClipToAxisRect(false);
}

QPointF polar_place(double degrees, double radius) {
  const double angle = degrees * std::numbers::pi / 180;
  return {radius * std::sin(angle), radius * std::cos(angle)};
}

void draw_polar_grid(QCustomPlot& plot, const plot::PolarScale& scale, const ThemeColours& colours) {
  QColor faint = colours.line;
  faint.setAlphaF(0.7F);
  for (const double ring : scale.rings()) {
    QList<QPointF> arc;
    for (int degrees = -90; degrees <= 90; degrees += 2) arc << polar_place(degrees, scale.fraction(ring));
    add_line(plot, arc, QPen(faint, 1));
    add_text(plot, number_text(ring), {scale.fraction(ring), 0}, Qt::AlignHCenter | Qt::AlignTop,
             colours.faint_text);
  }
  for (int degrees = -90; degrees <= 90; degrees += 30) {
    const QPointF end = polar_place(degrees, 1);
    add_line(plot, {QPointF(0, 0), end}, QPen(faint, 1));
    const Qt::Alignment side = degrees == 0  ? Qt::AlignHCenter | Qt::AlignBottom
                               : degrees < 0 ? Qt::AlignRight | Qt::AlignBottom
                                             : Qt::AlignLeft | Qt::AlignBottom;
    add_text(plot, QString("%1\u00b0").arg(std::abs(degrees)), end, side, colours.faint_text);
  }
}

void lay_out(QCPAxis& axis, const plot::Axis& meaning, const plot::AxisEnds& ends) {
  axis.setLabel(text_of(meaning.label));
  axis.setRange(ends.low, ends.high);
  if (meaning.is_logarithmic) axis.setScaleType(QCPAxis::stLogarithmic);
  constexpr double TwoDecades = 100;  // within which labels only at powers of ten are too few
  if (meaning.is_logarithmic && ends.high > TwoDecades * ends.low) {
    axis.setTicker(QSharedPointer<QCPAxisTicker>(new QCPAxisTickerLog));
    axis.setNumberPrecision(0);
    axis.setNumberFormat("eb");
  } else if (meaning.step > 0) {
    auto* ticker = new QCPAxisTickerFixed;
    ticker->setTickStep(meaning.step);
    axis.setTicker(QSharedPointer<QCPAxisTicker>(ticker));
  }
}

/// Fits a half circle into the widget, whose size is known after layout.
void fit_half_circle(QCustomPlot& plot) {
  plot.replot(QCustomPlot::rpQueuedRefresh);
  const QRect place = plot.axisRect()->rect();
  const double aspect = place.height() > 0 ? static_cast<double>(place.width()) / place.height() : 2;
  constexpr double Wide = 2.36;  // aspect ratio of the half circle with its labels
  constexpr double High = 1.28;
  const double width = std::max(Wide, High * aspect);
  const double height = width / aspect;
  plot.xAxis->setRange(-width / 2, width / 2);
  plot.yAxis->setRange(0.5 * High - 0.15 - height / 2, 0.5 * High - 0.15 + height / 2);
}

}  // namespace

void draw(QCustomPlot& plot, const plot::Chart& chart) {
  const ThemeColours colours = prepare(plot);
  const Theme theme = theme_of(plot.palette());
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const plot::Series& series = chart.series[i];
    QCPGraph* graph = plot.addGraph();
    for (const plot::Point& point : series.points) {
      const bool is_shown = !chart.y.is_logarithmic || point.y > 0;
      graph->addData(point.x, is_shown ? point.y : std::numeric_limits<double>::quiet_NaN());
    }
    graph->setPen(pen_of(series, colour_of(series, i, theme, colours)));
    if (!series.has_line) graph->setLineStyle(QCPGraph::lsNone);
    if (series.has_marks || !series.has_line)
      graph->setScatterStyle({QCPScatterStyle::ssDisc, series.has_line ? 5.0 : 2.5});
    graph->setName(text_of(series.name));
    if (series.name.empty()) graph->removeFromLegend();
  }
  plot.legend->setVisible(
      std::ranges::any_of(chart.series, [](const plot::Series& series) { return !series.name.empty(); }));
  lay_out(*plot.xAxis, chart.x, ends_of(chart.x, chart.series, &plot::Point::x));
  lay_out(*plot.yAxis, chart.y, ends_of(chart.y, chart.series, &plot::Point::y));
}

void draw(QCustomPlot& plot, const plot::PolarChart& chart) {
  const ThemeColours colours = prepare(plot);
  const Theme theme = theme_of(plot.palette());
  const plot::PolarScale scale(chart);
  draw_polar_grid(plot, scale, colours);
  const auto add = [&](const std::vector<plot::Series>& all, const auto& radius) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      QList<QPointF> line;
      for (const plot::Point& point : all[i].points) line << polar_place(point.x, radius(point.y));
      add_line(plot, line, pen_of(all[i], colour_of(all[i], i, theme, colours)), text_of(all[i].name));
    }
  };
  add(chart.series, [&](double value) { return scale.fraction(value); });
  add(chart.fractions, [](double radius) { return radius; });
  for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
    axis->setTickLabels(false);
    axis->setTicks(false);
    axis->setBasePen(Qt::NoPen);
    axis->grid()->setVisible(false);
  }
  plot.xAxis->setLabel(text_of(chart.unit) + "; the view is on the left");
  fit_half_circle(plot);
}

}  // namespace editor
