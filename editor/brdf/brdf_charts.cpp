// How the curves of a BRDF are drawn with QCustomPlot.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <qcustomplot.h>

#include "editor/appearance/theme.h"
#include "editor/brdf/brdf_plots.h"
#include "editor/controls/expression.h"

namespace editor {
namespace {

constexpr double NotShown = std::numeric_limits<double>::quiet_NaN();
constexpr int Decades = 5;  // that a logarithmic plot goes down from its peak

QFont small_font(const QCustomPlot& plot) {
  QFont font = plot.font();
  font.setPixelSize(11);
  return font;
}

/// An empty plot in the theme's colours, its legend under the axes.
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

QString quantity_name(const ChartStyle& style) { return style.with_cosine ? "f cos(light angle)" : "f"; }

/// The values of a curve as they are drawn.
QVector<double> shown_values(const LobeCurve& curve, const ChartStyle& style) {
  QVector<double> values;
  for (std::size_t i = 0; i < curve.values.size(); ++i) {
    const double cosine = style.with_cosine ? std::cos(curve.degrees[i] * std::numbers::pi / 180) : 1;
    values.push_back(channel_of(curve.values[i], style.channel) * cosine);
  }
  return values;
}

QVector<double> to_vector(const std::vector<double>& values) { return {values.begin(), values.end()}; }

/// A range that shows all curves: lobes that are far longer than another are cut.
double shown_peak(const LobeCurves& curves, const ChartStyle& style) {
  constexpr double TooLong = 8;  // times the shortest
  constexpr double Longest = 4;
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0;
  for (const LobeCurve& curve : curves.curves) {
    const QVector<double> values = shown_values(curve, style);
    const double peak = *std::max_element(values.begin(), values.end());
    longest = std::max(longest, peak);
    if (peak > 0) shortest = std::min(shortest, peak);
  }
  if (longest <= 0) return 1;
  return !style.is_logarithmic && longest > TooLong * shortest ? Longest * shortest : longest;
}

QPen pen_of(Theme theme, std::size_t number, Qt::PenStyle style) {
  QPen pen(series_colour(theme, static_cast<int>(number)), style == Qt::SolidLine ? 1.75 : 1.25, style);
  pen.setCosmetic(true);
  return pen;
}

QString view_name(double view) { return QString("view %1\u00b0").arg(view); }

/// Values to lengths from the centre, and back to what the rings are called.
struct PolarScale {
  double peak = 1;
  bool is_logarithmic = false;

  double length(double value) const {
    if (!is_logarithmic) return value / peak;
    return value > 0 ? std::max(0.0, 1 + std::log10(value / peak) / Decades) : 0;
  }
};

void add_line(QCustomPlot& plot, const QVector<double>& x, const QVector<double>& y, const QPen& pen,
              const QString& name = {}) {
  auto* curve = new QCPCurve(plot.xAxis, plot.yAxis);
  QVector<double> order(x.size());
  for (int i = 0; i < order.size(); ++i) order[i] = i;
  curve->setData(order, x, y, true);
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

QPointF polar_point(double degrees, double length) {
  const double angle = degrees * std::numbers::pi / 180;
  return {length * std::sin(angle), length * std::cos(angle)};
}

/// Values for some rings.
std::vector<double> ring_values(const PolarScale& scale) {
  std::vector<double> values;
  if (scale.is_logarithmic) {
    const double top = std::floor(std::log10(scale.peak) + 1e-9);
    for (int decade = 0; decade < Decades; ++decade) values.push_back(std::pow(10, top - decade));
    return values;
  }
  constexpr int MostRings = 4;
  const double power = std::pow(10, std::floor(std::log10(scale.peak / MostRings)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (scale.peak / (factor * power) <= MostRings) step = factor * power;
  }
  const int rings = static_cast<int>(1.001 * scale.peak / step);
  for (int ring = 1; ring <= rings; ++ring) values.push_back(ring * step);
  return values;
}

void draw_polar_grid(QCustomPlot& plot, const PolarScale& scale, const ThemeColours& colours) {
  QColor faint = colours.line;
  faint.setAlphaF(0.7F);
  const QPen pen(faint, 1);
  const auto half_circle = [&](double radius) {
    QVector<double> x;
    QVector<double> y;
    for (int degrees = -90; degrees <= 90; degrees += 2) {
      const QPointF point = polar_point(degrees, radius);
      x.push_back(point.x());
      y.push_back(point.y());
    }
    add_line(plot, x, y, pen);
  };
  half_circle(1.0);
  for (int degrees = -90; degrees <= 90; degrees += 30) {
    const QPointF end = polar_point(degrees, 1);
    add_line(plot, {0, end.x()}, {0, end.y()}, pen);
    const Qt::Alignment side = degrees == 0  ? Qt::AlignHCenter | Qt::AlignBottom
                               : degrees < 0 ? Qt::AlignRight | Qt::AlignBottom
                                             : Qt::AlignLeft | Qt::AlignBottom;
    add_text(plot, QString("%1\u00b0").arg(std::abs(degrees)), end, side, colours.faint_text);
  }
  for (const double value : ring_values(scale)) {
    const double radius = scale.length(value);
    if (radius < 0.999) half_circle(radius);
    add_text(plot, number_text(value), {radius, 0}, Qt::AlignHCenter | Qt::AlignTop, colours.faint_text);
  }
}

}  // namespace

void draw_polar(QCustomPlot& plot, const LobeCurves& curves, const ChartStyle& style) {
  const ThemeColours colours = prepare(plot);
  const Theme theme = theme_of(plot.palette());
  const PolarScale scale = {shown_peak(curves, style), style.is_logarithmic};
  draw_polar_grid(plot, scale, colours);
  for (std::size_t k = 0; k < curves.curves.size(); ++k) {
    const LobeCurve& curve = curves.curves[k];
    const auto add = [&](const QVector<double>& values, Qt::PenStyle pen_style, const QString& name) {
      QVector<double> x;
      QVector<double> y;
      for (int i = 0; i < values.size(); ++i) {
        const QPointF point =
            polar_point(curve.degrees[static_cast<std::size_t>(i)], scale.length(values[i]));
        x.push_back(point.x());
        y.push_back(point.y());
      }
      add_line(plot, x, y, pen_of(theme, k, pen_style), name);
    };
    add(shown_values(curve, style), Qt::SolidLine, view_name(curve.view));
    if (!curve.densities.empty()) add(to_vector(curve.densities), Qt::DashLine, {});
    const double mirror = channel_of(curve.mirror, style.channel);
    const QPointF end = polar_point(curve.view, mirror);
    if (mirror > 0) add_line(plot, {0, end.x()}, {0, end.y()}, pen_of(theme, k, Qt::DotLine));
  }
  for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
    axis->setTickLabels(false);
    axis->setTicks(false);
    axis->setBasePen(Qt::NoPen);
    axis->grid()->setVisible(false);
  }
  plot.xAxis->setLabel(quantity_name(style) + " in 1/sr; the view is on the left");
  // The half circle as large as the place allows, which is known once all is laid out.
  plot.replot(QCustomPlot::rpQueuedRefresh);
  const QRect place = plot.axisRect()->rect();
  const double aspect = place.height() > 0 ? static_cast<double>(place.width()) / place.height() : 2;
  constexpr double Wide = 2.36;  // of the half circle with its words
  constexpr double High = 1.28;
  const double width = std::max(Wide, High * aspect);
  const double height = width / aspect;
  plot.xAxis->setRange(-width / 2, width / 2);
  plot.yAxis->setRange(0.5 * High - 0.15 - height / 2, 0.5 * High - 0.15 + height / 2);
}

void draw_cartesian(QCustomPlot& plot, const LobeCurves& curves, const ChartStyle& style) {
  prepare(plot);
  const Theme theme = theme_of(plot.palette());
  const double peak = shown_peak(curves, style);
  double lowest = peak;
  const auto add = [&](const LobeCurve& curve, QVector<double> values, const QPen& pen, const QString& name) {
    for (double& value : values) {
      if (style.is_logarithmic && value <= 0) value = NotShown;
      if (value < lowest) lowest = value;
    }
    QCPGraph* graph = plot.addGraph();
    graph->setData(to_vector(curve.degrees), values, true);
    graph->setPen(pen);
    graph->setName(name);
    if (name.isEmpty()) graph->removeFromLegend();
  };
  for (std::size_t k = 0; k < curves.curves.size(); ++k) {
    const LobeCurve& curve = curves.curves[k];
    add(curve, shown_values(curve, style), pen_of(theme, k, Qt::SolidLine), view_name(curve.view));
    if (!curve.densities.empty()) add(curve, to_vector(curve.densities), pen_of(theme, k, Qt::DashLine), {});
    const double mirror = channel_of(curve.mirror, style.channel);
    if (mirror > 0) {
      const double bottom = style.is_logarithmic ? peak * std::pow(10, -Decades) : 0;
      add_line(plot, {curve.view, curve.view}, {bottom, peak * mirror}, pen_of(theme, k, Qt::DotLine));
    }
  }
  plot.xAxis->setRange(-90, 90);
  auto* ticker = new QCPAxisTickerFixed;
  ticker->setTickStep(30);
  plot.xAxis->setTicker(QSharedPointer<QCPAxisTicker>(ticker));
  plot.xAxis->setLabel("light angle in degrees; the view is on the left");
  plot.yAxis->setLabel(quantity_name(style) + " in 1/sr");
  if (style.is_logarithmic) {
    plot.yAxis->setScaleType(QCPAxis::stLogarithmic);
    plot.yAxis->setTicker(QSharedPointer<QCPAxisTicker>(new QCPAxisTickerLog));
    plot.yAxis->setNumberPrecision(0);
    plot.yAxis->setNumberFormat("eb");
    plot.yAxis->setRange(std::max(lowest / 1.5, peak * std::pow(10, -Decades)), peak * 2);
  } else {
    plot.yAxis->setRange(0, peak * 1.08);
  }
}

void draw_albedo(QCustomPlot& plot, const AlbedoCurve& curve) {
  const ThemeColours colours = prepare(plot);
  const Theme theme = theme_of(plot.palette());
  constexpr double Highest = 2;  // that is drawn
  double most = 1.05;
  const auto add = [&](const std::vector<reflectance::Rgb>& values, Qt::PenStyle style, const QString& more) {
    const bool is_grey = std::all_of(values.begin(), values.end(), [](const reflectance::Rgb& rgb) {
      return rgb.x == rgb.y && rgb.y == rgb.z;
    });
    for (int channel = 0; channel < (is_grey ? 1 : 3); ++channel) {
      QVector<double> shares;
      for (const reflectance::Rgb& value : values) shares.push_back(value[channel]);
      for (const double share : shares) most = std::max(most, 1.05 * share);
      QCPGraph* graph = plot.addGraph();
      graph->setData(to_vector(curve.degrees), shares, true);
      // Vermilion, green and blue of the series stand for the channels.
      constexpr std::array<std::size_t, 3> ChannelColours = {0, 2, 4};
      graph->setPen(pen_of(theme, is_grey ? 1 : ChannelColours[static_cast<std::size_t>(channel)], style));
      constexpr std::array<const char*, 3> Names = {"red", "green", "blue"};
      graph->setName((is_grey ? "albedo" : Names[static_cast<std::size_t>(channel)]) + more);
    }
  };
  add(curve.along_x, Qt::SolidLine, curve.along_y.empty() ? "" : ", along x");
  if (!curve.along_y.empty()) add(curve.along_y, Qt::DashLine, ", along y");
  QPen limit(colours.error, 1, Qt::DashLine);
  add_line(plot, {0, 90}, {1, 1}, limit);
  if (curve.largest.albedo > 1.005F) {
    add_text(plot, "more than it receives", {2, 1}, Qt::AlignLeft | Qt::AlignBottom, colours.error);
  }
  plot.xAxis->setRange(0, 90);
  auto* ticker = new QCPAxisTickerFixed;
  ticker->setTickStep(15);
  plot.xAxis->setTicker(QSharedPointer<QCPAxisTicker>(ticker));
  plot.xAxis->setLabel("view angle in degrees");
  plot.yAxis->setLabel("share of light reflected");
  plot.yAxis->setRange(0, std::min(most, Highest));
}

}  // namespace editor
