#include "renderer/command/sampling_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "grf/wording.h"
#include "renderer/plot/chart.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/light_angles.h"
#include "renderer/studies/disc_plot.h"
#include "renderer/studies/drawn_samples.h"

namespace command {
namespace {

using plot::Anchor;
using plot::Point;
using reflectance::SampledInstance;
using reflectance::Vec3f;
using studies::DiscMap;
using studies::DrawnSamples;
using studies::WeightStatistics;

constexpr double Width = 1200;
constexpr double Left = 24;
constexpr double HeaderHeight = 118;
constexpr double RowHeight = 268;
constexpr double DiscSide = 200;
// Left edges of the columns.
constexpr double PdfAt = Left;
constexpr double ScaleAt = PdfAt + DiscSide + 14;
constexpr double IdealAt = ScaleAt + 66;
constexpr double PolarAt = IdealAt + DiscSide + 26;
constexpr double WeightsAt = PolarAt + 312;

/// Azimuth of the default views: on the left, as in plots of the plane of incidence.
constexpr double DefaultAzimuth = std::numbers::pi;

constexpr std::string_view SchemeColour = "#d55e00";
constexpr std::string_view IdealColour = "#0072b2";
constexpr std::string_view Dashes = "6 3";

/// Returns the light direction at an angle in degrees in the plane of incidence; the view is on the left.
Vec3f light_at(double degrees, const Angles& view) {
  return direction_of({degrees * std::numbers::pi / 180, view.phi + std::numbers::pi});
}

/// A row of the plot: one view direction with its samples.
struct Row {
  const SampledInstance& instance;
  Angles view;
  Vec3f u;
  DrawnSamples drawn;
  WeightStatistics statistics;

  double pdf(const Vec3f& v) const { return instance.reflector.pdf(u, v); }
  double ideal(const Vec3f& v) const {
    if (!(statistics.albedo > 0)) return 0;
    return reflectance::mean(instance.reflector.evaluate(u, v)) * v.z / statistics.albedo;
  }
};

Row row_of(const SampledInstance& instance, const Angles& view) {
  constexpr std::uint32_t Samples = 1U << 15U;
  const Vec3f u = direction_of(view);
  // The albedo is estimated by the BRDF's own sampler, independently of the scheme.
  const reflectance::Reflector own(instance.reflector.brdf(), reflectance::OwnScheme());
  const double albedo = reflectance::mean(reflectance::albedo(own, u));
  DrawnSamples drawn = studies::draw_samples(instance.reflector, u, Samples, 0);
  const WeightStatistics statistics = statistics_of(drawn, albedo);
  return {instance, view, u, std::move(drawn), statistics};
}

void draw_discs(const Row& row, double top, plot::Svg& svg) {
  // Pdfs are per area of the disc, i.e. per projected solid angle: even dots mean an even colour.
  const auto on_area = [](double per_solid_angle, const Vec3f& v) { return per_solid_angle / v.z; };
  const DiscMap pdf([&](const Vec3f& v) { return on_area(row.pdf(v), v); });
  const DiscMap ideal([&](const Vec3f& v) { return on_area(row.ideal(v), v); });
  const plot::ColourScale scale(std::min(pdf.least(), ideal.least()),
                                std::max(pdf.largest(), ideal.largest()));
  std::vector<Vec3f> shown;
  constexpr std::size_t MostShown = 1000;
  for (const auto& sample : row.drawn.samples) {
    if (!sample.is_specular && shown.size() < MostShown) shown.push_back(sample.direction);
  }
  const plot::Rectangle left = {{PdfAt, top}, DiscSide, DiscSide};
  const plot::Rectangle right = {{IdealAt, top}, DiscSide, DiscSide};
  draw(pdf, scale, left, svg);
  studies::draw_directions(shown, left, SchemeColour, svg);
  studies::mark_view(row.u, left, svg);
  draw(ideal, scale, right, svg);
  studies::mark_view(row.u, right, svg);
  draw(scale, {{ScaleAt, top + 14}, 12, DiscSide - 28}, svg);
}

double peak_of(const plot::Series& series) {
  double peak = 0;
  for (const Point& point : series.points) peak = std::max(peak, point.y);
  return peak;
}

plot::PolarChart polar_of(const Row& row) {
  constexpr double TooLong = 8;  // times the other one
  constexpr double Longest = 4;
  plot::Series ideal = {{}, {}, IdealColour, {}};
  plot::Series pdf = {{}, {}, SchemeColour, Dashes};
  for (const double degrees : reflectance::light_angles(row.view.theta * 180 / std::numbers::pi)) {
    const Vec3f v = light_at(degrees, row.view);
    if (v.z <= 0) continue;
    ideal.points.emplace_back(degrees, row.ideal(v));
    pdf.points.emplace_back(degrees, row.pdf(v));
  }
  plot::PolarChart chart{{}, "1/sr", {}, {ideal, pdf}, {}, {}};
  const auto [shorter, longer] = std::minmax({peak_of(ideal), peak_of(pdf)});
  if (shorter > 0 && longer > TooLong * shorter) {
    chart.maximum = Longest * shorter;
    chart.note = fmt::format("cut: {} reaches {:.3g}",
                             peak_of(ideal) > peak_of(pdf) ? "f cos / albedo" : "the pdf", longer);
  }
  return chart;
}

/// Makes a histogram of the sample weights, as a step curve. The outermost bins include all weights beyond.
plot::Chart histogram_of(const Row& row) {
  constexpr int BinsPerDecade = 15;
  constexpr int Decades = 4;
  constexpr double Lowest = 0.01;
  constexpr int Bins = BinsPerDecade * Decades;
  std::array<double, Bins> fractions = {};
  for (const auto& sample : row.drawn.samples) {
    const double weight = reflectance::mean(sample.weight) / row.statistics.albedo;
    const double place = weight > 0 ? std::log10(weight / Lowest) * BinsPerDecade : 0;
    const double bin = std::clamp(std::floor(place + 0.5), 0.0, static_cast<double>(Bins - 1));
    fractions[static_cast<std::size_t>(bin)] += 100.0 / static_cast<double>(row.drawn.count());
  }
  plot::Series steps = {{}, {}, SchemeColour, {}};
  const auto edge = [](int bin) { return Lowest * std::pow(10, (bin - 0.5) / BinsPerDecade); };
  for (int bin = 0; bin < Bins; ++bin) {
    steps.points.emplace_back(edge(bin), fractions[static_cast<std::size_t>(bin)]);
    steps.points.emplace_back(edge(bin + 1), fractions[static_cast<std::size_t>(bin)]);
  }
  plot::Chart chart{{},
                    {"weight / albedo (end bins include all beyond)", true, 0.01, 100, 0},
                    {"% of samples", false, 0, {}, 0},
                    {}};
  chart.y.maximum = std::max(1.0, 1.05 * peak_of(steps));
  chart.series = {{{}, {Point(1, 0), Point(1, *chart.y.maximum)}, "#111", "2 3"}, steps};
  return chart;
}

/// Formats an angle for labels.
std::string degrees_text(double radians) {
  return fmt::format("{:.4g}\u00B0", radians * 180 / std::numbers::pi);
}

std::string facts_of(const Row& row) {
  const WeightStatistics& statistics = row.statistics;
  if (!(statistics.albedo > 0)) return "reflects nothing";
  std::string text =
      fmt::format("albedo {:.3g}   \u00B7   weights: variance {:.3g}, largest {:.3g}, mean {:.3f}",
                  statistics.albedo, statistics.variance, statistics.largest, statistics.mean);
  const auto add = [&](double fraction, const char* what) {
    if (fraction > 0) text += fmt::format("   \u00B7   {:.3g} % of samples {}", 100 * fraction, what);
  };
  add(statistics.rejected, "rejected");
  add(statistics.specular, "specular");
  return text;
}

void draw_row(const Row& row, double top, plot::Svg& svg) {
  svg.line({Left, top}, {Width - Left, top}, {"#ccc", 1});
  std::string view = "View " + degrees_text(row.view.theta);
  if (row.view.phi != DefaultAzimuth) view += ", azimuth " + degrees_text(row.view.phi);
  svg.text({Left, top + 19}, view, {13, "#111", Anchor::Start, 0});
  svg.text({IdealAt, top + 19}, facts_of(row), {12, "#333", Anchor::Start, 0});
  draw_discs(row, top + 34, svg);
  draw(polar_of(row), {{PolarAt, top + 6}, 300, RowHeight - 30}, svg);
  if (row.statistics.albedo > 0) {
    draw(histogram_of(row), {{WeightsAt, top + 14}, Width - Left - WeightsAt, RowHeight - 28}, svg);
  }
}

std::string sampling_time_text(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.3g} \u00B5s", 1e6 * seconds);
  return seconds < 1 ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.3g} s", seconds);
}

std::string costs_of(const SampledInstance& instance, const std::vector<Row>& rows) {
  double seconds = 0;
  std::size_t count = 0;
  for (const Row& row : rows) {
    seconds += row.drawn.seconds;
    count += row.drawn.count();
  }
  std::string tables = "no tables";
  if (const std::size_t bytes = instance.reflector.bytes(); bytes > 0) {
    tables = fmt::format("tables: {}, built in {}", grf::bytes_text(bytes),
                         sampling_time_text(instance.build_seconds));
  }
  return fmt::format("{}   \u00B7   {:.0f} ns per sample   \u00B7   cosine-weighted: {:.3g} %", tables,
                     1e9 * seconds / static_cast<double>(std::max<std::size_t>(1, count)),
                     100 * instance.reflector.cosine_fraction());
}

void draw_header(const std::string& brdf, const std::string& pdf, const std::string& costs, plot::Svg& svg) {
  constexpr double Inside = Width - 2 * Left;
  svg.text({Left, 32}, brdf, {plot::fitting_size(17, brdf, Inside), "#111", Anchor::Start, 0});
  svg.text({Left, 56}, "sampled by " + pdf,
           {plot::fitting_size(13, pdf, Inside / 2), "#111", Anchor::Start, 0});
  svg.text({Width - Left, 56}, costs, {12, "#333", Anchor::End, 0});
  constexpr double Y = HeaderHeight - 31;
  const auto heading = [&](double x, const char* words, const char* meaning) {
    svg.text({x, Y}, words, {13, "#111", Anchor::Start, 0});
    svg.text({x, Y + 17}, meaning, {11, "#666", Anchor::Start, 0});
  };
  heading(PdfAt, "Pdf and 1000 samples", "on the unit disc, per projected solid angle");
  heading(IdealAt, "f cos / albedo", "the ideal pdf, in the same colours");
  heading(PolarAt, "In the plane of incidence", "");
  heading(WeightsAt + 62, "Weights f cos / pdf", "1 for perfect importance sampling");
  svg.line({PolarAt, Y + 13}, {PolarAt + 22, Y + 13}, {SchemeColour, 2, Dashes});
  svg.text({PolarAt + 27, Y + 17}, "pdf", {11, "#333", Anchor::Start, 0});
  svg.line({PolarAt + 88, Y + 13}, {PolarAt + 110, Y + 13}, {IdealColour, 2});
  svg.text({PolarAt + 115, Y + 17}, "f cos / albedo", {11, "#333", Anchor::Start, 0});
}

std::vector<Angles> default_views() {
  std::vector<Angles> views;
  for (const double degrees : {0, 45, 80})
    views.push_back({degrees * std::numbers::pi / 180, DefaultAzimuth});
  return views;
}

}  // namespace

plot::Svg picture_of_sampling(const SampledInstance& instance, const std::string& brdf,
                              const std::string& pdf, const std::vector<Angles>& views) {
  std::vector<Row> rows;
  for (const Angles& view : views.empty() ? default_views() : views) rows.push_back(row_of(instance, view));
  plot::Svg svg(Width, HeaderHeight + RowHeight * static_cast<double>(rows.size()));
  draw_header(brdf, pdf, costs_of(instance, rows), svg);
  double top = HeaderHeight;
  for (const Row& row : rows) {
    draw_row(row, top, svg);
    top += RowHeight;
  }
  return svg;
}

}  // namespace command
