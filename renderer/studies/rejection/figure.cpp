#include "renderer/studies/rejection/figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace studies {
namespace {

using plot::Anchor;
using plot::Point;
using plot::Rectangle;
using plot::Svg;
namespace colours = rejection_colours;

constexpr Rectangle NumbersPlace = {{590, 92}, 430, 200};
constexpr Rectangle HistogramPlace = {{590, 304}, 440, 302};
constexpr double RowHeight = 19;

void draw_header(const RejectionReport& report, const std::vector<LegendItem>& legend, Svg& svg) {
  svg.text({20, 30}, report.title,
           {plot::fitting_size(17, report.title, RejectionWidth - 40), "#111", Anchor::Start, 0});
  svg.text({20, 52}, report.note, {12, "#333", Anchor::Start, 0});
  double x = 20;
  for (const LegendItem& item : legend) {
    if (item.is_line) {
      svg.line({x, 72}, {x + 16, 72}, {item.colour, 2.4});
    } else {
      svg.dots(std::array{Point(x + 8, 72)}, 4, item.colour);
    }
    svg.text({x + 21, 76}, item.words, {11, "#333", Anchor::Start, 0});
    x += 38 + 5.9 * static_cast<double>(item.words.size());
  }
}

std::string percent(double fraction) { return fmt::format("{:.3g} %", 100 * fraction); }

/// Formats three digits, or all before the point.
std::string rounded(double value) {
  return value < 999.5 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

std::string duration(double nanoseconds) {
  if (nanoseconds < 999.5) return rounded(nanoseconds) + " ns";
  if (nanoseconds < 999.5e3) return rounded(nanoseconds / 1e3) + " \u00B5s";
  return rounded(nanoseconds / 1e6) + " ms";
}

bool is_failure(const std::optional<double>& p_value) { return p_value && *p_value < LeastPValue; }

void draw_p_value(const MethodNumbers& numbers, const Point& at, Svg& svg) {
  svg.text(at, numbers.p_value ? p_value_text(*numbers.p_value) : std::string("-"),
           {12, is_failure(numbers.p_value) ? colours::Warning : "#333", Anchor::End, 0});
}

void draw_numbers(const RejectionReport& report, Svg& svg) {
  const double left = NumbersPlace.corner.x;
  const double right = left + NumbersPlace.width;
  const double middle = right - 150;
  double y = NumbersPlace.corner.y + 14;
  const auto row = [&](std::string_view name, const std::string& single, const std::string& tree) {
    svg.text({left, y}, name, {12, "#333", Anchor::Start, 0});
    svg.text({middle, y}, single, {12, "#333", Anchor::End, 0});
    svg.text({right, y}, tree, {12, "#333", Anchor::End, 0});
    y += RowHeight;
  };
  svg.text({left, y}, "Tries for a sample", {13, "#111", Anchor::Start, 0});
  svg.text({middle, y}, "one bound", {12, colours::Bound, Anchor::End, 0});
  svg.text({right, y}, report.subdivision, {12, colours::Tree, Anchor::End, 0});
  svg.line({left, y + 6}, {right, y + 6}, {"#bbb", 1});
  y += RowHeight + 4;
  const MethodNumbers& single = report.single;
  const MethodNumbers tree = report.tree.value_or(MethodNumbers{"none"});
  const auto of_tree = [&](const std::string& words) { return report.tree ? words : std::string("-"); };
  const auto measured = [](const MethodNumbers& numbers, const std::string& words) {
    return numbers.tries_per_sample > 0 ? words : std::string("-");
  };
  row("bound", single.bound, tree.bound);
  row("accepted, expected", percent(single.expected), of_tree(percent(tree.expected)));
  row("accepted, measured", percent(single.acceptance), of_tree(percent(tree.acceptance)));
  row("tries per sample", measured(single, rounded(single.tries_per_sample)),
      of_tree(rounded(tree.tries_per_sample)));
  row("time per sample", measured(single, duration(single.nanoseconds_per_sample)),
      of_tree(duration(tree.nanoseconds_per_sample)));
  svg.text({left, y}, "chi-square test", {12, "#333", Anchor::Start, 0});
  draw_p_value(single, {middle, y}, svg);
  draw_p_value(tree, {right, y}, svg);
  y += RowHeight + 3;
  std::vector<std::string> remarks = report.remarks;
  if (!report.tree) remarks.push_back(report.no_tree_reason);
  const auto draw_line = [&](const std::string& words, std::string_view colour) {
    svg.text({left, y}, words,
             {plot::fitting_size(11, words, 1.1 * NumbersPlace.width), colour, Anchor::Start, 0});
    y += 16;
  };
  for (const std::string& remark : remarks) draw_line(remark, "#666");
  for (const std::string& warning : report.warnings) draw_line(warning, colours::Warning);
}

/// Returns the outline of the bars.
std::vector<Point> outline(const Histogram& histogram) {
  const double width = (histogram.high - histogram.low) / static_cast<double>(histogram.densities.size());
  std::vector<Point> points = {{histogram.low, 0}};
  for (std::size_t i = 0; i < histogram.densities.size(); ++i) {
    const double from = histogram.low + width * static_cast<double>(i);
    points.emplace_back(from, histogram.densities[i]);
    points.emplace_back(from + width, histogram.densities[i]);
  }
  points.emplace_back(histogram.high, 0);
  return points;
}

/// Returns the top of the axis: over the bars, and over the curves unless they have a pole.
double top_of(const Histogram& histogram) {
  const double bars = *std::ranges::max_element(histogram.densities);
  double top = 0;
  for (const std::vector<Point>* curve : {&histogram.expected, &histogram.sampled}) {
    for (const Point& point : *curve) top = std::max(top, point.y);
  }
  if (!(bars > 0)) return top > 0 ? 1.1 * top : 1;
  return 1.1 * std::max(bars, std::min(top, 2.5 * bars));
}

void draw_histogram(const RejectionReport& report, Svg& svg) {
  const Histogram& histogram = report.histogram;
  plot::Chart chart;
  chart.title = "Accepted samples and the density";
  chart.x = {histogram.x_label, false, histogram.low, histogram.high};
  chart.y = {histogram.y_label, false, 0, top_of(histogram)};
  plot::Series bars = {"", outline(histogram), colours::Bar};
  bars.fill = colours::Bar;
  bars.has_line = false;
  chart.series.push_back(std::move(bars));
  chart.series.push_back({"", histogram.expected, colours::Function});
  if (!histogram.sampled.empty()) chart.series.push_back({"", histogram.sampled, colours::Warning, "5 3"});
  draw(chart, HistogramPlace, svg);
  const std::optional<double>& p_value = report.single.p_value;
  const std::string words =
      p_value ? fmt::format("chi-square {}", p_value_text(*p_value)) : std::string("too few samples to test");
  const double right = HistogramPlace.corner.x + HistogramPlace.width - 10;
  svg.text({right, HistogramPlace.corner.y + 14}, words,
           {12, is_failure(p_value) ? colours::Warning : "#333", Anchor::End, 0});
  if (histogram.sampled.empty()) return;
  const double y = HistogramPlace.corner.y + 40;
  svg.line({right - 176, y - 4}, {right - 156, y - 4}, {colours::Warning, 1.6, "5 3"});
  svg.text({right - 150, y}, "what this bound samples", {11, "#333", Anchor::Start, 0});
}

}  // namespace

void add_warnings(std::size_t tries, std::size_t accepted, std::size_t above, std::size_t wanted,
                  std::vector<std::string>& warnings) {
  if (above > 0)
    warnings.push_back(
        fmt::format("The bound is too low at {} of {} tries: samples are missing there.", above, tries));
  if (accepted < wanted)
    warnings.push_back(
        fmt::format("Stopped after {} tries, with {} of {} samples.", tries, accepted, wanted));
}

std::string compared_maxima(double exact, double grid, std::string_view grid_name) {
  if (!std::isfinite(exact)) return fmt::format("Maximum: infinite; {}: {:.5g}.", grid_name, grid);
  const std::string difference =
      grid < exact ? fmt::format(", {:.3g} % lower", 100 * (1 - grid / exact)) : std::string(", the same");
  return fmt::format("Maximum: {:.5g}; {}: {:.5g}{}.", exact, grid_name, grid, difference);
}

void draw_report(const RejectionReport& report, const std::vector<LegendItem>& legend, Svg& svg) {
  draw_header(report, legend, svg);
  draw_numbers(report, svg);
  draw_histogram(report, svg);
}

plot::Series dots_of(std::vector<Point> points, std::string_view colour) {
  plot::Series series = {"", std::move(points), colour};
  series.has_line = false;
  return series;
}

plot::Series lost_above(const std::vector<Point>& curve, double bound) {
  plot::Series lost = {"", {}, colours::Lost};
  for (const Point& point : curve) {
    if (std::isfinite(point.y)) lost.points.emplace_back(point.x, std::max(point.y, bound));
  }
  if (!curve.empty()) {
    lost.points.emplace_back(curve.back().x, bound);
    lost.points.emplace_back(curve.front().x, bound);
  }
  lost.fill = colours::Lost;
  lost.has_line = false;
  return lost;
}

std::string p_value_text(double p_value) {
  return p_value < 1e-6 ? std::string("p < 0.000001") : fmt::format("p = {:.3g}", p_value);
}

std::string summary_of(const RejectionReport& report, std::size_t tries, std::size_t accepted) {
  std::string text =
      fmt::format("{}: {} samples from {} tries, {} accepted, {} expected", report.title, accepted, tries,
                  percent(report.single.acceptance), percent(report.single.expected));
  if (report.single.p_value) text += fmt::format("; chi-square {}", p_value_text(*report.single.p_value));
  if (report.tree)
    text += fmt::format("; the {} accepts {}", report.subdivision, percent(report.tree->acceptance));
  text += '.';
  for (const std::string& warning : report.warnings) text += ' ' + warning;
  return text;
}

}  // namespace studies
