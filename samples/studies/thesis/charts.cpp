#include "samples/studies/thesis/charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "renderer/plot/chart.h"
#include "renderer/reflectance/scheme.h"
#include "samples/studies/thesis/lobe_fit.h"

namespace study {
namespace {

using plot::Point;

struct Style {
  std::string_view technique, colour, dashes;
};

/// One colour per kind of technique; lines of adjusted techniques are solid.
constexpr std::array<Style, 12> Styles = {{{"uniform", "#999999", ""},
                                           {"sphere", "#e69f00", "4 3"},
                                           {"sphere-best", "#e69f00", ""},
                                           {"hemisphere", "#009e73", "4 3"},
                                           {"hemisphere-best", "#009e73", ""},
                                           {"factored", "#cc79a7", "4 3"},
                                           {"factored-best", "#cc79a7", ""},
                                           {"factored-fine", "#cc79a7", "1 2"},
                                           {"cascade", "#56b4e9", ""},
                                           {"reject", "#d55e00", ""},
                                           {"warp", "#0072b2", ""},
                                           {"own", "#111111", "4 3"}}};

constexpr std::string_view Resampled = "-ris";

plot::Series series_of(const std::string& technique, std::vector<Point> points) {
  const bool is_resampled = technique.ends_with(Resampled);
  const std::string_view plain =
      std::string_view(technique).substr(0, technique.size() - (is_resampled ? Resampled.size() : 0));
  const auto style =
      std::find_if(Styles.begin(), Styles.end(), [&](const Style& one) { return one.technique == plain; });
  return {technique, std::move(points), style == Styles.end() ? "" : style->colour,
          is_resampled ? "6 2 1 2" : (style == Styles.end() ? "" : style->dashes)};
}

plot::Chart printed_chart(const PrintedTable& times, const PrintedTable& errors) {
  plot::Chart chart{"thesis", {"sampling time, s", true, {}, {}, 0}, {"error, %", true, {}, {}, 0}, {}};
  for (const PrintedRow& row : errors.rows) {
    std::vector<Point> points;
    for (const int count : errors.samples) {
      const auto seconds = times.value(row.technique, count);
      const auto error = errors.value(row.technique, count);
      if (seconds && error) points.emplace_back(*seconds, *error);
    }
    chart.series.push_back(series_of(row.technique, std::move(points)));
  }
  return chart;
}

/// Returns true for a constant technique if the table has the adjusted one, and vice versa.
bool is_of_other_kind(const std::string& technique, const PrintedTable& errors) {
  constexpr std::string_view Adjusted = "-best";
  const bool is_adjusted = technique.ends_with(Adjusted);
  const std::string other = is_adjusted ? technique.substr(0, technique.size() - Adjusted.size())
                                        : technique + std::string(Adjusted);
  return std::any_of(errors.rows.begin(), errors.rows.end(),
                     [&](const PrintedRow& row) { return row.technique == other; });
}

plot::Chart todays_chart(const Results& results, const std::string& scene, const std::string& integrator,
                         const PrintedTable& errors) {
  plot::Chart chart{"today, " + integrator,
                    {"build and render time, s", true, {}, {}, 0},
                    {"error, %", true, {}, {}, 0},
                    {}};
  for (const std::string& technique : results.names({scene, {}, {}, integrator}, &Row::technique)) {
    if (is_of_other_kind(technique, errors)) continue;
    std::vector<Point> points;
    for (const int count : results.counts({scene, {}, technique, integrator})) {
      const RowFilter filter = {scene, {}, technique, integrator, count};
      points.emplace_back(results.mean(filter, [](const Row& row) { return row.total(); }).value(),
                          results.mean(filter, [](const Row& row) { return 100 * row.error; }).value());
    }
    chart.series.push_back(series_of(technique, std::move(points)));
  }
  return chart;
}

constexpr double Width = 430;
constexpr double Height = 330;

}  // namespace

plot::Svg time_error_chart(const Results& results, const std::string& scene, const PrintedTable& times,
                           const PrintedTable& errors) {
  plot::Svg svg(3 * Width + 20, Height + 20);
  draw(printed_chart(times, errors), {{10, 10}, Width, Height}, svg);
  draw(todays_chart(results, scene, "naive", errors), {{10 + Width, 10}, Width, Height}, svg);
  draw(todays_chart(results, scene, "path", errors), {{10 + 2 * Width, 10}, Width, Height}, svg);
  return svg;
}

plot::Svg lobe_chart() {
  using namespace reflectance;
  const Brdf brdf = brdf_of("lewis n=32.5 ks=0.5 kd=0.5");
  const double view = std::numbers::pi / 4;
  const Vec3f u(static_cast<float>(std::sin(view)), 0, static_cast<float>(std::cos(view)));
  const auto lobe = [&](double exponent) {
    HemisphereScheme scheme;
    scheme.exponent = static_cast<float>(exponent);
    scheme.build(brdf);
    return scheme;
  };
  const double best = best_lobe_exponent(brdf);
  const std::array<HemisphereScheme, 3> lobes = {lobe(32.5), lobe(16), lobe(best)};
  plot::Chart chart{
      "", {"angle of v, degrees; u at -45", false, -90, 90, 30}, {"pdf, 1/sr", false, 0, {}, 0}, {}};
  chart.series = {{"f cos / albedo", {}, "#111111"},
                  {"lobe, n = 32.5", {}, "#e69f00"},
                  {"lobe, n = 16", {}, "#009e73"},
                  {fmt::format("lobe, n = {:g}", best), {}, "#0072b2", "4 3"}};
  double albedo = 0;
  constexpr int Steps = 400;
  for (int i = 0; i < Steps; ++i) {
    for (int k = 0; k < Steps; ++k) {
      const double z = (i + 0.5) / Steps;
      const double sine = std::sqrt(1 - z * z);
      const double phi = 2 * std::numbers::pi * (k + 0.5) / Steps;
      const Vec3f v(static_cast<float>(sine * std::cos(phi)), static_cast<float>(sine * std::sin(phi)),
                    static_cast<float>(z));
      albedo += mean(evaluate(brdf, u, v)) * z * 2 * std::numbers::pi / (Steps * Steps);
    }
  }
  for (int degrees = -89; degrees <= 89; ++degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vec3f v(static_cast<float>(-std::sin(angle)), 0, static_cast<float>(std::cos(angle)));
    chart.series[0].points.emplace_back(degrees, mean(evaluate(brdf, u, v)) * v.z / albedo);
    for (std::size_t i = 0; i < lobes.size(); ++i) {
      chart.series[i + 1].points.emplace_back(degrees, lobes[i].pdf(brdf, u, v));
    }
  }
  plot::Svg svg(680, 350);
  draw(chart, {{10, 10}, 660, 330}, svg);
  return svg;
}

}  // namespace study
