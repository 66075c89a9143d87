#include "samples/studies/sampling/charts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "renderer/plot/chart.h"
#include "samples/studies/sampling/tables.h"

namespace study {
namespace {

using plot::Anchor;
using plot::Point;
using plot::Svg;

struct Style {
  std::string_view colour;
  bool is_second = false;  ///< of two of a colour: a ring, or a line of dashes
};

constexpr std::array<Style, TechniqueNames.size()> Styles = {{{"#999999"},
                                                              {"#e69f00", true},
                                                              {"#e69f00"},
                                                              {"#009e73", true},
                                                              {"#009e73"},
                                                              {"#cc79a7"},
                                                              {"#56b4e9"},
                                                              {"#d55e00"},
                                                              {"#0072b2"},
                                                              {"#111111", true}}};

plot::Chart convergence_of(const CaseResult& result, bool has_names) {
  plot::Chart chart{fmt::format("{}, environment map", result.subject->name),
                    {"samples (Sobol)", true, 1, SampleCounts.back(), 0},
                    {"relative error", true, {}, {}, 0},
                    {}};
  for (std::size_t id = 0; id < TechniqueNames.size(); ++id) {
    plot::Series series{has_names ? std::string(TechniqueNames[id]) : "",
                        {},
                        Styles[id].colour,
                        Styles[id].is_second ? "4 3" : ""};
    for (std::size_t count = 0; count < SampleCounts.size(); ++count) {
      const double error = result.techniques[id].error(Environment, Sobol, count).value();
      series.points.emplace_back(SampleCounts[count], error);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

/// Selects some BRDFs in even steps from the glossiest to the most diffuse.
std::vector<const CaseResult*> shown_in_convergence(const Results& results) {
  std::vector<const CaseResult*> shown;
  for (const CaseResult& one : results.cases) shown.push_back(&one);
  std::stable_sort(shown.begin(), shown.end(), [](const CaseResult* a, const CaseResult* b) {
    return (*a)[Diffuse].fit.deviation > (*b)[Diffuse].fit.deviation;
  });
  constexpr std::size_t Most = 6;
  std::vector<const CaseResult*> some;
  const std::size_t count = std::min(Most, shown.size());
  for (std::size_t i = 0; i < count; ++i) {
    some.push_back(shown[count > 1 ? i * (shown.size() - 1) / (count - 1) : 0]);
  }
  return some;
}

/// A logarithmic axis from 10^low to 10^high.
struct LogAxis {
  double low, high, from, to;

  double place(double value) const {
    return from + (to - from) * std::clamp((std::log10(value) - low) / (high - low), 0.0, 1.0);
  }
};

double error_of(const CaseResult& result, std::size_t id, Light light) {
  return result.techniques[id].error(light, Sobol, MostSamples).value();
}

LogAxis axis_for(const Results& results, Light light, double from, double to) {
  double least = HUGE_VAL;
  double largest = 0;
  for (const CaseResult& one : results.cases) {
    for (std::size_t id = 0; id < TechniqueNames.size(); ++id) {
      least = std::min(least, error_of(one, id, light));
      largest = std::max(largest, error_of(one, id, light));
    }
  }
  const double low = std::floor(std::log10(std::max(least, 1e-6)));
  return {low, std::max(low + 1, std::ceil(std::log10(std::max(largest, 1e-6)))), from, to};
}

constexpr double RowHeight = 20;
constexpr double Top = 62;

void draw_mark(const Point& at, const Style& style, Svg& svg) {
  if (style.is_second) {
    svg.circle(at, 4, {style.colour, 1.6});
  } else {
    const std::array<Point, 1> one = {at};
    svg.dots(one, 4, style.colour);
  }
}

void draw_panel(const Results& results, Light light, double left, double width, Svg& svg) {
  const double bottom = Top + RowHeight * static_cast<double>(results.cases.size());
  const LogAxis axis = axis_for(results, light, left, left + width);
  svg.text({left, Top - 12}, LightNames[light], {13, "#111"});
  for (int exponent = static_cast<int>(axis.low); exponent <= axis.high; ++exponent) {
    const double x = axis.place(std::pow(10, exponent));
    svg.line({x, Top}, {x, bottom}, {"#ddd", 1});
    svg.text({x, bottom + 15}, fmt::format("{:g}", std::pow(10, exponent)), {11, "#333", Anchor::Middle});
  }
  double y = Top + RowHeight / 2;
  for (const CaseResult& one : results.cases) {
    svg.line({left, y}, {left + width, y}, {"#eee", 1});
    for (std::size_t id = 0; id < TechniqueNames.size(); ++id) {
      draw_mark({axis.place(error_of(one, id, light)), y}, Styles[id], svg);
    }
    y += RowHeight;
  }
  svg.text({left + width / 2, bottom + 32}, "relative error", {11, "#333", Anchor::Middle});
}

void draw_names(Svg& svg) {
  double x = 100;
  for (std::size_t id = 0; id < TechniqueNames.size(); ++id) {
    draw_mark({x, 20}, Styles[id], svg);
    svg.text({x + 8, 24}, TechniqueNames[id], {11});
    x += 26 + 6.4 * static_cast<double>(TechniqueNames[id].size());
  }
}

}  // namespace

Svg convergence_chart(const Results& results) {
  constexpr double Width = 300;
  constexpr double Height = 270;
  constexpr double NamesWidth = 130;
  const std::vector<const CaseResult*> shown = shown_in_convergence(results);
  const std::size_t columns = std::min<std::size_t>(3, shown.size());
  const std::size_t rows = (shown.size() + columns - 1) / columns;
  Svg svg(Width * static_cast<double>(columns) + NamesWidth + 20, Height * static_cast<double>(rows) + 10);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const bool has_names = i + 1 == columns;
    const Point corner(10 + Width * static_cast<double>(i % columns),
                       10 + Height * static_cast<double>(i / columns));
    draw(convergence_of(*shown[i], has_names), {corner, has_names ? Width + NamesWidth : Width, Height}, svg);
  }
  return svg;
}

Svg scheme_chart(const Results& results) {
  constexpr double Left = 100;
  constexpr double Width = 230;
  constexpr double Gap = 30;
  Svg svg(Left + LightCount * (Width + Gap),
          Top + RowHeight * static_cast<double>(results.cases.size()) + 45);
  draw_names(svg);
  double y = Top + RowHeight / 2 + 4;
  for (const CaseResult& one : results.cases) {
    svg.text({Left - 12, y}, one.subject->name + (one.is_glossy ? "*" : ""), {11, "#333", Anchor::End});
    y += RowHeight;
  }
  double left = Left;
  for (const Light light : LightsByWeight) {
    draw_panel(results, light, left, Width, svg);
    left += Width + Gap;
  }
  return svg;
}

}  // namespace study
