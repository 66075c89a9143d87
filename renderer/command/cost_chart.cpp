#include "renderer/command/cost_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "renderer/plot/chart.h"

namespace command {
namespace {

/// Rounds outwards to 1, 2 or 5 times a power of ten.
double round_outwards(double value, bool upwards) {
  constexpr std::array<double, 4> Factors = {1, 2, 5, 10};
  const double decade = std::pow(10, std::floor(std::log10(value)));
  double rounded = Factors[0];
  for (const double factor : Factors) {
    if (upwards && factor * decade >= value * (1 - 1e-9)) return factor * decade;
    if (factor * decade <= value * (1 + 1e-9)) rounded = factor;
  }
  return rounded * decade;
}

void fit_ends(plot::Axis& axis, const std::vector<plot::Series>& series, double plot::Point::*coordinate) {
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
  for (const plot::Series& one : series) {
    for (const plot::Point& point : one.points) {
      low = std::min(low, point.*coordinate);
      high = std::max(high, point.*coordinate);
    }
  }
  if (!(low > 0) || !(high > 0) || !std::isfinite(low)) return;
  axis.minimum = round_outwards(low, false);
  axis.maximum = round_outwards(high, true);
}

/// The style of a line. Lines that differ only by the integrator share a colour; `naive` is dashed.
struct Style {
  std::string_view colour;
  std::string_view dashes;
};

std::vector<Style> styles_of(const CostResult& result) {
  const auto is_naive = [](const CostLineResult& one) { return one.line.options.integrator == "naive"; };
  const auto naive_count = std::count_if(result.lines.begin(), result.lines.end(), is_naive);
  const bool are_mixed = naive_count > 0 && naive_count < static_cast<std::ptrdiff_t>(result.lines.size());
  std::map<std::string, std::size_t> colours;
  std::vector<Style> styles;
  for (const CostLineResult& one : result.lines) {
    std::string name = one.line.name;
    const std::size_t at = are_mixed ? name.find(one.line.options.integrator) : std::string::npos;
    if (at != std::string::npos) name.erase(at, one.line.options.integrator.size());
    const std::size_t number = colours.try_emplace(name, colours.size()).first->second;
    const bool is_second = number >= 7;  // there are no more colours
    styles.push_back({plot::colour_of_series(number), are_mixed && is_naive(one)
                                                          ? (is_second ? "2 2" : "6 3")
                                                          : (is_second ? "9 2 2 2" : "")});
  }
  return styles;
}

template <class Abscissa>
plot::Chart chart_of(const CostResult& result, const std::string& label, const Abscissa& x_of) {
  plot::Chart chart;
  chart.x = {label, true, {}, {}, 0};
  chart.y = {"error, sqrt(relMSE), %", true, {}, {}, 0};
  chart.has_names_at_ends = true;
  const std::vector<Style> styles = styles_of(result);
  for (std::size_t i = 0; i < result.lines.size(); ++i) {
    plot::Series series{result.lines[i].line.name, {}, styles[i].colour, styles[i].dashes, true};
    for (const CostRow& row : result.lines[i].rows) {
      if (row.relmse > 0) series.points.emplace_back(x_of(row), 100 * row.error());
    }
    chart.series.push_back(std::move(series));
  }
  fit_ends(chart.x, chart.series, &plot::Point::x);
  fit_ends(chart.y, chart.series, &plot::Point::y);
  return chart;
}

}  // namespace

plot::Svg cost_chart(const CostResult& result) {
  constexpr double ChartHeight = 400;
  std::size_t longest = 0;
  for (const CostLineResult& one : result.lines) longest = std::max(longest, one.line.name.size());
  const double width = 440 + (result.lines.size() > 1 ? 7 * static_cast<double>(longest) : 0);
  plot::Svg svg(2 * width + 30, ChartHeight + 20);
  plot::Chart over_time =
      chart_of(result, "render time, s", [](const CostRow& row) { return row.render_seconds; });
  over_time.title =
      fmt::format("{}, {}x{} pixels, {} thread{}", grf::file_name(result.scene), result.width, result.height,
                  result.conditions.threads, result.conditions.threads == 1 ? "" : "s");
  const plot::Chart over_samples = chart_of(
      result, "samples per pixel", [](const CostRow& row) { return static_cast<double>(row.samples); });
  draw(over_time, {{10, 10}, width, ChartHeight}, svg);
  draw(over_samples, {{20 + width, 10}, width, ChartHeight}, svg);
  return svg;
}

}  // namespace command
