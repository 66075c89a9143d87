#include "renderer/command/brdf_fit_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command_line/report_document.h"
#include "grf/text_file.h"
#include "renderer/fit/metric.h"
#include "renderer/plot/brdf_charts.h"
#include "renderer/plot/chart.h"
#include "renderer/reflectance/merl_table.h"
#include "renderer/studies/angles.h"

namespace command {
namespace {

using command_line::ReportDocument;
using fit::Fit;
using fit::Metric;
using fit::Observation;
using plot::Series;
using studies::Degree;

constexpr std::array<double, 4> ChartViews = {0, 30, 60, 75};
constexpr std::size_t MostDots = 3000;

double mean_of(const fit::Vec3d& value) { return (value.x + value.y + value.z) / 3; }

Series lobe_of(const reflectance::Brdf& brdf, double view) {
  Series series;
  const plot::LobeCurve curve = plot::lobe_curve(brdf, view);
  for (std::size_t i = 0; i < curve.degrees.size(); ++i)
    series.points.emplace_back(curve.degrees[i], reflectance::mean(curve.values[i]));
  return series;
}

/// Returns the observations of about a view that are about in the plane of incidence, as points of the
/// light's angle and the value.
std::vector<plot::Point> points_of(const std::vector<Observation>& list, double view) {
  constexpr double Near = 3;  // degrees
  std::vector<plot::Point> points;
  for (const Observation& one : list) {
    const double radius = std::hypot(one.u.x, one.u.y);
    if (std::abs(std::atan2(radius, one.u.z) / Degree - view) > Near) continue;
    const bool is_upright = radius < 1e-3;
    const double x = is_upright ? -1 : one.u.x / radius;
    const double y = is_upright ? 0 : one.u.y / radius;
    const double along = -(one.v.x * x + one.v.y * y);  // positive on the side away from the view
    const double across = one.v.y * x - one.v.x * y;
    if (std::abs(std::asin(std::clamp(across, -1.0, 1.0))) > Near * Degree) continue;
    points.emplace_back(std::atan2(along, one.v.z) / Degree, mean_of(one.value));
  }
  return points;
}

/// Makes a chart of the data, as lines of a BRDF or else as dots, with the fit dashed.
plot::Chart lobes_chart(const BrdfFits& fits, const Fit& fit) {
  plot::Chart chart;
  chart.title = "In the plane of incidence: data, and dashed the fit";
  chart.x = {"angle of the light in degrees", false, -90, 90, 30};
  chart.y = {"f in 1/sr", true, {}, {}, 0};
  double peak = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ChartViews.size(); ++i) {
    Series data;
    if (fits.brdf) {
      data = lobe_of(*fits.brdf, ChartViews[i]);
    } else {
      data.points = points_of(fits.observations.list, ChartViews[i]);
      data.has_line = false;
    }
    Series line = lobe_of(fit.brdf, ChartViews[i]);
    if (data.points.empty()) continue;
    for (const plot::Point& point : data.points) {
      peak = std::max(peak, point.y);
      if (point.y > 0) least = std::min(least, point.y);
    }
    data.name = fmt::format("view {}\u00B0", ChartViews[i]);
    data.colour = plot::colour_of_series(i);
    line.colour = data.colour;
    line.dashes = "5 3";
    chart.series.push_back(std::move(data));
    chart.series.push_back(std::move(line));
  }
  if (peak > 0) {
    chart.y.maximum = std::pow(10, std::ceil(std::log10(peak)));
    const double lowest = std::pow(10, std::floor(std::log10(std::max(least, *chart.y.maximum * 1e-5))));
    chart.y.minimum = std::min(lowest, *chart.y.maximum / 10);
  }
  return chart;
}

/// Makes a chart of the residuals in the metric over an angle of the half vector's coordinates, in degrees.
plot::Chart residuals_chart(const BrdfFits& fits, const std::vector<fit::Vec3d>& values, const char* label,
                            double reflectance::HalfAngles::*angle) {
  const std::vector<Observation>& list = fits.observations.list;
  const fit::MetricScale scale(fits.metric, fit::mean_of(list));
  Series dots;
  dots.has_line = false;
  const std::size_t step = std::max<std::size_t>(1, list.size() / MostDots);
  for (std::size_t i = 0; i < list.size(); i += step) {
    const Observation& one = list[i];
    const double residual =
        scale.value(mean_of(values[i]) * one.v.z) - scale.value(mean_of(one.value) * one.v.z);
    dots.points.emplace_back(reflectance::half_angles(one.u, one.v).*angle / Degree, residual);
  }
  plot::Chart chart;
  chart.title = fmt::format("Residuals in the metric {}", name_of(fits.metric));
  chart.x = {label, false, 0, 90, 15};
  chart.y = {"fit - data", false, {}, {}, 0};
  chart.series.push_back(std::move(dots));
  return chart;
}

plot::Svg picture_of(const BrdfFits& fits, const Fit& fit) {
  std::vector<fit::Vec3d> values;
  fit::evaluate(fit.brdf, fits.observations.list, values);
  plot::Svg svg(980, 640);
  draw(lobes_chart(fits, fit), {{20, 20}, 940, 290}, svg);
  draw(residuals_chart(fits, values, "theta of the half vector in degrees",
                       &reflectance::HalfAngles::theta_half),
       {{20, 330}, 460, 290}, svg);
  draw(residuals_chart(fits, values, "angle of the light to the half vector in degrees",
                       &reflectance::HalfAngles::theta_difference),
       {{500, 330}, 460, 290}, svg);
  return svg;
}

std::string percent_text(double fraction) { return fmt::format("{:.3g} %", 100 * fraction); }

void add_ranking(const BrdfFits& fits, ReportDocument& document) {
  std::vector<ReportDocument::Row> rows = {{"model"}};
  for (const Metric metric : fit::Metrics) rows[0].push_back(fmt::format("{} (rank)", name_of(metric)));
  rows[0].emplace_back("seconds");
  std::array<std::vector<std::size_t>, fit::Metrics.size()> orders;
  for (std::size_t i = 0; i < orders.size(); ++i) orders[i] = ranking(fits.fits, fit::Metrics[i]);
  for (std::size_t place = 0; place < fits.fits.size(); ++place) {
    const Fit& one = fits.fits[place];
    ReportDocument::Row& row = rows.emplace_back(ReportDocument::Row{one.target.name()});
    for (std::size_t i = 0; i < orders.size(); ++i) {
      const auto rank = std::find(orders[i].begin(), orders[i].end(), place) - orders[i].begin() + 1;
      row.push_back(fmt::format("{} ({})", percent_text(one.errors[i].relative), rank));
    }
    row.push_back(fmt::format("{:.2g}", one.seconds));
  }
  document.add_table(std::move(rows));
}

void add_fit(const Fit& fit, const std::string& picture, ReportDocument& document) {
  document.add_heading(2, fit.target.name());
  document.add_code(text_of(fit));
  std::vector<ReportDocument::Row> rows = {{"parameter", "value", "interval of 95 %"}};
  for (const fit::FittedParameter& parameter : fit.parameters)
    rows.push_back({name_of(parameter, fit), fmt::format("{:.5g}", parameter.value), interval_of(parameter)});
  document.add_table(std::move(rows));
  for (const std::string& warning : fit.warnings) document.add_paragraph("Warning: " + warning + ".");
  if (!fit.held.empty())
    document.add_paragraph(fmt::format("Parameters that were held: {}.", fmt::join(fit.held, "; ")));
  document.add_picture(picture, "Lobes and residuals of " + fit.target.name());
}

}  // namespace

std::string name_of(const fit::FittedParameter& parameter, const Fit& fit) {
  constexpr std::array<const char*, 3> Channels = {" red", " green", " blue"};
  std::string name = fit.terms.size() > 1 ? fmt::format("{} ", parameter.term + 1) : "";
  name += parameter.name;
  if (parameter.channel) name += Channels[static_cast<std::size_t>(*parameter.channel)];
  return name;
}

std::string interval_of(const fit::FittedParameter& parameter) {
  if (!parameter.is_determined) return "not determined by the data";
  if (parameter.is_at_bound) return "at the end of its range";
  return fmt::format("{:.5g} to {:.5g}", parameter.low, parameter.high);
}

bool write_fit_report(const BrdfFits& fits, const std::string& folder, grf::Diagnostics& diagnostics) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    diagnostics.error(grf::whole_file(folder), "cannot make the folder: " + error.message());
    return false;
  }
  ReportDocument document;
  document.add_heading(1, "Fit of " + fits.data);
  document.add_paragraph(fmt::format("Data: {}.", fits.observations.description));
  document.add_paragraph(fmt::format(
      "The models were fitted in the metric {}. Errors are root mean squares in each metric, over "
      "that of the data; f is weighted by the cosine of the light.",
      name_of(fits.metric)));
  add_ranking(fits, document);
  bool was_written = true;
  for (std::size_t i = 0; i < fits.fits.size(); ++i) {
    const std::string picture = fmt::format("fit-{}.svg", i + 1);
    add_fit(fits.fits[i], picture, document);
    const std::string path = (std::filesystem::path(folder) / picture).string();
    was_written &= plot::write_picture(picture_of(fits, fits.fits[i]), path, diagnostics);
  }
  const auto write = [&](const char* name, const std::string& text) {
    was_written &= grf::replace_file((std::filesystem::path(folder) / name).string(), text, diagnostics);
  };
  write("report.md", document.markdown());
  write("report.html", document.html());
  return was_written;
}

}  // namespace command
