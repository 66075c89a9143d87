#include "renderer/plot/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

namespace plot {
namespace {

constexpr Stroke Grid = {"#ddd", 1};
constexpr Stroke Frame = {"#888", 1};
constexpr double LineWidth = 1.6;
constexpr double SmallText = 11;
constexpr int Decades = 5;  // of a logarithmic polar chart

/// Returns the next larger step of 1, 2 or 5 times a power of ten.
double round_step(double step) {
  const double power = std::pow(10, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 2.5, 5.0}) {
    if (step <= factor * power * 1.0001) return factor * power;
  }
  return 10 * power;
}

/// Maps values of an axis to pixels.
class Scale {
 public:
  Scale(const Axis& axis, const std::vector<Series>& series, double Point::*coordinate, double from,
        double to)
      : is_logarithmic_(axis.is_logarithmic), step_(axis.step), from_(from), to_(to) {
    const AxisEnds ends = ends_of(axis, series, coordinate);
    low_ = on_axis(ends.low);
    high_ = on_axis(ends.high);
    if (!(high_ > low_)) high_ = low_ + 1;
  }

  bool has_place(double value) const { return std::isfinite(value); }
  double place(double value) const {
    // The clamp keeps 0 on a logarithmic axis far outside, as any value outside will do.
    const double fraction = std::clamp((on_axis(value) - low_) / (high_ - low_), -10.0, 10.0);
    return from_ + fraction * (to_ - from_);
  }

  std::vector<double> ticks() const {
    std::vector<double> values;
    if (is_logarithmic_) {
      const int step = std::max(1, static_cast<int>(std::ceil((high_ - low_) / 6)));
      if (step == 1 && !(is_whole(low_) && is_whole(high_))) return ticks_within_decades();
      for (int exponent = static_cast<int>(std::ceil(low_)); exponent <= high_ + 1e-9; exponent += step) {
        values.push_back(std::pow(10, exponent));
      }
      return values;
    }
    const double step = step_ > 0 ? step_ : round_step((high_ - low_) / 5);
    for (double k = std::ceil(low_ / step - 1e-9); k * step <= high_ + 1e-9 * step; ++k)
      values.push_back(k * step);
    return values;
  }

 private:
  static bool is_whole(double exponent) { return std::abs(exponent - std::round(exponent)) < 1e-9; }

  /// Returns ticks at 1, 2 and 5 times powers of ten, as far as there is space.
  std::vector<double> ticks_within_decades() const {
    std::vector<double> values;
    for (int decade = static_cast<int>(std::floor(low_)); decade <= high_; ++decade) {
      for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor > 1 && high_ - low_ > 3) continue;
        const double value = factor * std::pow(10, decade);
        const double exponent = std::log10(value);
        if (exponent >= low_ - 1e-9 && exponent <= high_ + 1e-9) values.push_back(value);
      }
    }
    return values;
  }

  double on_axis(double value) const { return is_logarithmic_ ? std::log10(std::max(value, 1e-300)) : value; }

  bool is_logarithmic_;
  double step_;
  double from_, to_;
  double low_ = 0;
  double high_ = 1;
};

std::string label_of(double value) {
  const double size = std::abs(value);
  if (size == 0) return "0";  // and not -0
  if (size >= 1e-3 && size < 9999.5) return fmt::format("{:.4g}", value);
  const double exponent = std::floor(std::log10(size) + 1e-9);
  return fmt::format("{:.3g}e{}", value / std::pow(10, exponent), exponent);
}

void draw_title(const std::string& title, const Rectangle& place, Svg& svg) {
  svg.text({place.corner.x, place.corner.y + 14}, title, {13, "#111", Anchor::Start, 0});
}

std::string_view colour_of(const std::vector<Series>& series, std::size_t index) {
  return series[index].colour.empty() ? colour_of_series(index) : series[index].colour;
}

bool has_legend(const std::vector<Series>& series) {
  return std::count_if(series.begin(), series.end(), [](const Series& one) { return !one.name.empty(); }) > 1;
}

/// Draws the legend at the right, each label at the end of a stroke of its colour.
void draw_legend(const std::vector<Series>& series, const Point& corner, Svg& svg) {
  if (!has_legend(series)) return;
  double y = corner.y;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (series[i].name.empty()) continue;
    svg.line({corner.x, y}, {corner.x + 16, y}, {colour_of(series, i), LineWidth + 1, series[i].dashes});
    svg.text({corner.x + 21, y + 4}, series[i].name, {SmallText, "#333", Anchor::Start, 0});
    y += 16;
  }
}

double legend_width(const std::vector<Series>& series) {
  if (!has_legend(series)) return 10;
  std::size_t longest = 0;
  for (const Series& one : series) longest = std::max(longest, one.name.size());
  return 30 + 6.8 * static_cast<double>(longest);
}

std::vector<Point> line_of(const Series& series, const Scale& x, const Scale& y) {
  std::vector<Point> line;
  for (const Point& point : series.points) {
    if (x.has_place(point.x) && y.has_place(point.y)) line.emplace_back(x.place(point.x), y.place(point.y));
  }
  return line;
}

/// Fills the area between a line and the x axis, lighter than the line.
void fill_below(const std::vector<Point>& line, double bottom, std::string_view colour, Svg& svg) {
  if (line.empty()) return;
  std::vector<Point> area = line;
  area.emplace_back(line.back().x, bottom);
  area.emplace_back(line.front().x, bottom);
  const auto plain = plot::colour_of(colour);
  svg.polygon(area, plain ? hexadecimal(*plain * 0.45F + grf::Colour(0.55F)) : std::string(colour), 0);
}

void draw_lines(const Chart& chart, const Scale& x, const Scale& y, double bottom, Svg& svg) {
  constexpr double MarkRadius = 2.6;
  constexpr double CloudRadius = 1.2;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const std::vector<Point> line = line_of(chart.series[i], x, y);
    const bool has_line = chart.series[i].has_line;
    if (chart.series[i].is_filled) fill_below(line, bottom, colour_of(chart.series, i), svg);
    if (has_line) svg.polyline(line, {colour_of(chart.series, i), LineWidth, chart.series[i].dashes});
    if (chart.series[i].has_marks || !has_line)
      svg.dots(line, has_line ? MarkRadius : CloudRadius, colour_of(chart.series, i));
  }
}

void draw_names_at_ends(const Chart& chart, const Scale& x, const Scale& y, const Rectangle& inside,
                        Svg& svg) {
  std::vector<std::size_t> named;
  std::vector<Point> ends;
  std::vector<double> wishes;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const std::vector<Point> line = line_of(chart.series[i], x, y);
    if (chart.series[i].name.empty() || line.empty()) continue;
    named.push_back(i);
    ends.push_back(line.back());
    wishes.push_back(line.back().y);
  }
  constexpr double Distance = 15;
  const double right = inside.corner.x + inside.width;
  const std::vector<double> heights =
      spread_labels(wishes, Distance, inside.corner.y + 4, inside.corner.y + inside.height - 4);
  for (std::size_t k = 0; k < named.size(); ++k) {
    const Series& series = chart.series[named[k]];
    const std::string_view colour = colour_of(chart.series, named[k]);
    const std::array<Point, 3> way = {ends[k], Point(right + 4, heights[k]), Point(right + 10, heights[k])};
    svg.polyline(way, {colour, 0.7, "1 2"});
    svg.line({right + 10, heights[k]}, {right + 26, heights[k]}, {colour, LineWidth + 1, series.dashes});
    svg.text({right + 31, heights[k] + 4}, series.name, {SmallText, "#333", Anchor::Start, 0});
  }
}

void draw_axes(const Chart& chart, const Scale& x, const Scale& y, const Rectangle& inside, Svg& svg) {
  const double left = inside.corner.x;
  const double top = inside.corner.y;
  const double right = left + inside.width;
  const double bottom = top + inside.height;
  for (const double tick : x.ticks()) {
    svg.line({x.place(tick), top}, {x.place(tick), bottom}, Grid);
    svg.text({x.place(tick), bottom + 15}, label_of(tick), {SmallText, "#333", Anchor::Middle, 0});
  }
  for (const double tick : y.ticks()) {
    svg.line({left, y.place(tick)}, {right, y.place(tick)}, Grid);
    svg.text({left - 6, y.place(tick) + 4}, label_of(tick), {SmallText, "#333", Anchor::End, 0});
  }
  svg.line({left, bottom}, {right, bottom}, Frame);
  svg.line({left, top}, {left, bottom}, Frame);
  svg.text({(left + right) / 2, bottom + 32}, chart.x.label, {SmallText, "#333", Anchor::Middle, 0});
  svg.text({left - 46, (top + bottom) / 2}, chart.y.label, {SmallText, "#333", Anchor::Middle, -90});
}

}  // namespace

AxisEnds ends_of(const Axis& axis, const std::vector<Series>& series, double Point::*coordinate) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Series& one : series) {
    for (const Point& point : one.points) {
      const double value = point.*coordinate;
      if (!std::isfinite(value) || (axis.is_logarithmic && value <= 0)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (!(low <= high)) low = high = 1;
  if (axis.is_logarithmic) {
    low = std::pow(10, std::floor(std::log10(low)));
    high = std::pow(10, std::ceil(std::log10(high)));
  }
  return {axis.minimum.value_or(low), axis.maximum.value_or(high)};
}

std::string_view colour_of_series(std::size_t index) {
  constexpr std::array<std::string_view, 7> Colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                       "#56b4e9", "#e69f00", "#555555"};
  return Colours[index % Colours.size()];
}

std::vector<double> spread_labels(const std::vector<double>& wishes, double distance, double from,
                                  double to) {
  std::vector<std::size_t> order(wishes.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return wishes[a] < wishes[b]; });
  // Minus a step per predecessor, positions must not fall. Those that would are merged into a block at the
  // mean of its members' wishes (Kruskal 1964, "Nonmetric multidimensional scaling": isotonic regression).
  struct Block {
    double sum = 0;
    double count = 0;

    double mean() const { return sum / count; }
  };
  std::vector<Block> blocks;
  for (std::size_t k = 0; k < order.size(); ++k) {
    blocks.push_back({wishes[order[k]] - distance * static_cast<double>(k), 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() > blocks.back().mean()) {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back().sum += last.sum;
      blocks.back().count += last.count;
    }
  }
  const double room = to - from - distance * (static_cast<double>(order.size()) - 1);
  std::vector<double> places(wishes.size());
  std::size_t k = 0;
  for (const Block& block : blocks) {
    const double place = std::clamp(block.mean(), from, from + std::max(0.0, room));
    for (int i = 0; i < block.count; ++i, ++k) {
      places[order[k]] = place + distance * static_cast<double>(k);
    }
  }
  return places;
}

void draw(const Chart& chart, const Rectangle& place, Svg& svg) {
  const Rectangle inside = {
      {place.corner.x + 62, place.corner.y + 26},
      place.width - 62 - legend_width(chart.series) - (chart.has_names_at_ends ? 10 : 0),
      place.height - 66};
  const Scale x(chart.x, chart.series, &Point::x, inside.corner.x, inside.corner.x + inside.width);
  const Scale y(chart.y, chart.series, &Point::y, inside.corner.y + inside.height, inside.corner.y);
  draw_title(chart.title, place, svg);
  draw_axes(chart, x, y, inside, svg);
  svg.begin_clip(inside.corner - Point(0, 1), inside.width, inside.height + 2);
  draw_lines(chart, x, y, inside.corner.y + inside.height, svg);
  svg.end_clip();
  if (chart.has_names_at_ends && has_legend(chart.series)) {
    draw_names_at_ends(chart, x, y, inside, svg);
  } else {
    draw_legend(chart.series, {inside.corner.x + inside.width + 10, inside.corner.y + 8}, svg);
  }
}

namespace {

double largest_distance(const Series& series) {
  double largest = 0;
  for (const Point& point : series.points) largest = std::max(largest, point.y);
  return largest;
}

/// Returns the largest value that the rings must cover.
double largest_distance(const PolarChart& chart) {
  double largest = 0;
  for (const Series& one : chart.series) largest = std::max(largest, largest_distance(one));
  if (chart.maximum) largest = std::min(largest, *chart.maximum);
  return largest > 0 ? largest : 1;
}

/// A half circle in which values are fractions of its radius.
class Fan {
 public:
  Fan(const Point& centre, double radius) : centre_(centre), radius_(radius) {}

  const Point& centre() const { return centre_; }
  Point at(double degrees, double fraction) const {
    const double angle = degrees * std::numbers::pi / 180;
    return centre_ + Point(std::sin(angle), -std::cos(angle)) * (fraction * radius_);
  }

  void draw_rings(const PolarScale& scale, Svg& svg) const {
    for (const double ring : scale.rings()) {
      std::vector<Point> arc;
      for (int degrees = -90; degrees <= 90; degrees += 3) arc.push_back(at(degrees, scale.fraction(ring)));
      svg.polyline(arc, Grid);
      svg.text(at(90, scale.fraction(ring)) + Point(0, 14), label_of(ring),
               {SmallText, "#333", Anchor::Middle, 0});
    }
    svg.text(centre_ + Point(0, 14), "0", {SmallText, "#333", Anchor::Middle, 0});
  }

  void draw_spokes(Svg& svg) const {
    for (int degrees = -90; degrees <= 90; degrees += 30) {
      svg.line(centre_, at(degrees, 1), Grid);
      if (std::abs(degrees) == 90) continue;
      svg.text(at(degrees, 1.06), fmt::format("{}\u00B0", std::abs(degrees)),
               {SmallText, "#333", Anchor::Middle, 0});
    }
    svg.line(at(-90, 1), at(90, 1), Frame);
  }

  template <class Share>
  void draw_lines(const std::vector<Series>& series, const Share& fraction, Svg& svg) const {
    for (std::size_t i = 0; i < series.size(); ++i) {
      std::vector<Point> line;
      for (const Point& point : series[i].points) line.push_back(at(point.x, fraction(point.y)));
      svg.polyline(line, {colour_of(series, i), LineWidth, series[i].dashes});
    }
  }

 private:
  Point centre_;
  double radius_;
};

}  // namespace

PolarScale::PolarScale(const PolarChart& chart) : is_logarithmic_(chart.is_logarithmic) {
  const double largest = largest_distance(chart);
  if (is_logarithmic_) {
    outermost_ = largest;
    const double top = std::floor(std::log10(largest) + 1e-9);
    for (int decade = Decades - 1; decade >= 0; --decade) rings_.push_back(std::pow(10, top - decade));
    if (rings_.back() < 0.98 * largest) rings_.push_back(largest);
    return;
  }
  const double step = round_step(largest / 3);
  const int count = static_cast<int>(std::ceil(largest / step - 1e-9));
  for (int k = 1; k <= count; ++k) rings_.push_back(k * step);
  outermost_ = rings_.back();
}

double PolarScale::fraction(double value) const {
  if (value >= outermost_) return 1;
  if (!is_logarithmic_) return value / outermost_;
  return value > 0 ? std::max(0.0, 1 + std::log10(value / outermost_) / Decades) : 0;
}

void draw(const PolarChart& chart, const Rectangle& place, Svg& svg) {
  constexpr double LeastLegend = 130;  // so that charts of one kind are of one size
  const double legend = legend_width(chart.series);
  const double width = place.width - (has_legend(chart.series) ? std::max(LeastLegend, legend) : legend);
  const double radius = std::min(width / 2 - 18, place.height - 86);
  const PolarScale scale(chart);
  const Fan fan({place.corner.x + 18 + radius, place.corner.y + 40 + radius}, radius);
  draw_title(chart.title, place, svg);
  fan.draw_rings(scale, svg);
  fan.draw_spokes(svg);
  svg.text(fan.centre() + Point(0, 32), chart.unit, {SmallText, "#333", Anchor::Middle, 0});
  svg.text(fan.centre() + Point(0, 48), chart.note, {SmallText, "#333", Anchor::Middle, 0});
  fan.draw_lines(
      chart.series, [&](double value) { return scale.fraction(value); }, svg);
  fan.draw_lines(
      chart.fractions, [](double fraction) { return fraction; }, svg);
  std::vector<Series> named = chart.series;
  for (Series& one : named) {
    const double reach = largest_distance(one);
    if (reach > scale.outermost()) one.name += fmt::format(", to {:.3g}", reach);
  }
  draw_legend(named, {place.corner.x + width + 4, place.corner.y + 48}, svg);
}

}  // namespace plot
