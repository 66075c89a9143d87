#include "renderer/plot/brdf_charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "renderer/parallel/loops.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/light_angles.h"
#include "renderer/reflectance/spectrum.h"

namespace plot {
namespace {

using reflectance::Rgb;
using reflectance::Vec3f;

constexpr double Radian = std::numbers::pi / 180;
constexpr std::string_view Dashes = "5 3";

/// Makes the series of values over the light's angle.
Series series_of(const LobeCurve& curve, const LobeStyle& style) {
  Series series{fmt::format("view {}\u00B0", curve.view), {}, {}, {}};
  for (std::size_t i = 0; i < curve.degrees.size(); ++i) {
    const double value = channel_of(curve.values[i], style.channel);
    const double cosine = style.with_cosine ? direction_at(curve.degrees[i]).z : 1;
    series.points.emplace_back(curve.degrees[i], value * cosine);
  }
  return series;
}

double peak_of(const Series& series) {
  double peak = 0;
  for (const Point& point : series.points) peak = std::max(peak, point.y);
  return peak;
}

std::vector<Series> all_series(std::span<const LobeCurve> curves, const LobeStyle& style) {
  std::vector<Series> series;
  for (const LobeCurve& curve : curves) series.push_back(series_of(curve, style));
  return series;
}

void add_pdfs(std::span<const LobeCurve> curves, std::vector<Series>& series) {
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (curves[k].pdfs.empty()) continue;
    Series& pdfs = series.emplace_back(Series{{}, {}, colour_of_series(k), Dashes});
    for (std::size_t i = 0; i < curves[k].degrees.size(); ++i) {
      pdfs.points.emplace_back(curves[k].degrees[i], curves[k].pdfs[i]);
    }
  }
}

/// Makes a line per view with a delta part, as long as its weight.
std::vector<Series> specular_lines(std::span<const LobeCurve> curves, Channel channel,
                                   std::string_view dashes) {
  constexpr double Seen = 0.005;
  std::vector<Series> lines;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const double weight = channel_of(curves[k].specular_weight, channel);
    if (weight <= Seen) continue;
    lines.push_back(
        {{}, {Point(curves[k].view, 0), Point(curves[k].view, weight)}, colour_of_series(k), dashes});
  }
  return lines;
}

std::string quantity(const LobeStyle& style) { return style.with_cosine ? "f cos in 1/sr" : "f in 1/sr"; }

/// Makes a series per channel, or one if they are equal.
std::vector<Series> albedo_series(const std::vector<double>& degrees, const std::vector<Rgb>& values) {
  constexpr std::array<const char*, 3> Names = {"red", "green", "blue"};
  constexpr std::array<std::string_view, 3> Colours = {"#d55e00", "#009e73", "#0072b2"};
  std::vector<Series> channels;
  for (std::size_t i = 0; i < 3; ++i) channels.push_back({Names[i], {}, Colours[i], {}});
  bool is_grey = true;
  for (std::size_t k = 0; k < degrees.size(); ++k) {
    const Rgb& value = values[k];
    is_grey = is_grey && value.x == value.y && value.y == value.z;
    for (std::size_t i = 0; i < 3; ++i) {
      channels[i].points.emplace_back(degrees[k], value[static_cast<int>(i)]);
    }
  }
  if (is_grey) return {{"albedo", channels[0].points, colour_of_series(0), {}}};
  return channels;
}

}  // namespace

double channel_of(const Rgb& rgb, Channel channel) {
  switch (channel) {
    case Channel::Red:
      return rgb.x;
    case Channel::Green:
      return rgb.y;
    case Channel::Blue:
      return rgb.z;
    case Channel::Mean:
      return reflectance::mean(rgb);
    case Channel::Luminance:
      break;
  }
  return reflectance::luminance(rgb);
}

Vec3f direction_at(double degrees) {
  return {static_cast<float>(std::sin(degrees * Radian)), 0, static_cast<float>(std::cos(degrees * Radian))};
}

LobeCurve lobe_curve(const reflectance::Brdf& brdf, double view, const reflectance::Reflector* reflector) {
  LobeCurve curve;
  curve.view = view;
  const Vec3f u = direction_at(-view);
  curve.specular_weight = reflectance::specular_weight(brdf, u);
  for (const double degrees : reflectance::light_angles(view)) {
    const Vec3f v = direction_at(degrees);
    curve.degrees.push_back(degrees);
    curve.values.push_back(reflectance::evaluate(brdf, u, v));
    if (reflector != nullptr) curve.pdfs.push_back(reflector->pdf(u, v));
  }
  return curve;
}

AlbedoCurve albedo_curve(const reflectance::Reflector& reflector, int samples,
                         const std::function<bool()>& is_stopped) {
  AlbedoCurve curve;
  // The steps are smaller towards the horizon, where the curve bends most.
  for (int degrees = 0; degrees < 90; degrees += degrees < 70 ? 2 : 1) curve.degrees.push_back(degrees);
  const bool has_y = reflectance::is_anisotropic(reflector.brdf());
  curve.along_x.resize(curve.degrees.size());
  if (has_y) curve.along_y.resize(curve.degrees.size());
  parallel::for_each_index(curve.degrees.size(), [&](std::size_t i) {
    if (is_stopped && is_stopped()) return;
    const Vec3f u = direction_at(curve.degrees[i]);
    curve.along_x[i] = reflectance::albedo(reflector, u, samples);
    if (has_y) curve.along_y[i] = reflectance::albedo(reflector, Vec3f(0, u.x, u.z), samples);
  });
  for (const std::vector<Rgb>* values : {&curve.along_x, &curve.along_y}) {
    for (std::size_t i = 0; i < values->size(); ++i) {
      const float most = reflectance::largest((*values)[i]);
      if (most > curve.largest.albedo) curve.largest = {most, static_cast<float>(curve.degrees[i])};
    }
  }
  return curve;
}

Chart lobe_chart(std::span<const LobeCurve> curves, const LobeStyle& style) {
  constexpr double Shown = 1e-6;  // of the peak
  Chart chart{"BRDF in the plane of incidence",
              {"light angle in degrees; the view is on the left", false, -90, 90, 30},
              {quantity(style), style.is_logarithmic, {}, {}, 0},
              all_series(curves, style)};
  add_pdfs(curves, chart.series);
  double peak = 0;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Series& series : chart.series) {
    peak = std::max(peak, peak_of(series));
    for (const Point& point : series.points) {
      if (point.y > 0) lowest = std::min(lowest, point.y);
    }
  }
  if (!(peak > 0)) chart.title += ": 0 except for the delta part";
  if (!style.is_logarithmic) {
    chart.y.minimum = 0;
    chart.y.maximum = 1.08 * peak;
  }
  if (style.is_logarithmic && peak > 0 && lowest < Shown * peak) {
    chart.y.minimum = std::pow(10, std::floor(std::log10(Shown * peak)));
  }
  return chart;
}

void add_specular_lines(Chart& chart, std::span<const LobeCurve> curves, Channel channel) {
  double peak = 0;
  for (const Series& series : chart.series) peak = std::max(peak, peak_of(series));
  for (Series& line : specular_lines(curves, channel, "1 3")) {
    for (Point& point : line.points) point.y *= peak > 0 ? peak : 1;
    chart.series.push_back(std::move(line));
  }
}

PolarChart polar_lobe_chart(std::span<const LobeCurve> curves, const LobeStyle& style) {
  constexpr double TooLong = 8;  // times the shortest
  constexpr double Longest = 4;
  PolarChart chart{
      style.with_cosine ? "BRDF times cosine of the light" : "BRDF", quantity(style), {}, {}, {}, {}};
  chart.series = all_series(curves, style);
  chart.is_logarithmic = style.is_logarithmic;
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0;
  for (const Series& series : chart.series) {
    shortest = std::min(shortest, peak_of(series));
    longest = std::max(longest, peak_of(series));
  }
  if (!style.is_logarithmic && shortest > 0 && longest > TooLong * shortest)
    chart.maximum = Longest * shortest;
  add_pdfs(curves, chart.series);
  chart.fractions = specular_lines(curves, style.channel, Dashes);
  if (!chart.fractions.empty()) chart.note = "dashed: the delta part; the outermost ring is an albedo of 1";
  return chart;
}

Chart albedo_chart(const AlbedoCurve& curve) {
  constexpr double Highest = 2;  // that is drawn
  Chart chart{"Albedo", {"view angle in degrees", false, 0, 90, 15}, {"albedo", false, 0, {}, 0}, {}};
  chart.series = albedo_series(curve.degrees, curve.along_x);
  if (!curve.along_y.empty()) {
    for (Series& series : chart.series) series.name += ", along x";
    for (Series& series : albedo_series(curve.degrees, curve.along_y)) {
      series.name += ", along y";
      series.dashes = Dashes;
      chart.series.push_back(series);
    }
  }
  const double largest = curve.largest.albedo;
  chart.y.maximum = std::clamp(largest, 1.0, Highest);
  if (largest > 1.002) {
    chart.title += fmt::format(": up to {:.3g}, above 1", largest);
    chart.series.push_back({{}, {Point(0, 1), Point(90, 1)}, "#111", "2 3"});
  }
  return chart;
}

std::optional<Chart> spectrum_chart(const reflectance::Brdf& brdf, std::span<const double> views) {
  std::vector<float> wavelengths = reflectance::wavelengths_of(brdf);
  if (wavelengths.empty()) return std::nullopt;
  const bool is_data = std::holds_alternative<reflectance::Rgl>(brdf);
  if (!is_data) {
    wavelengths.clear();
    for (int nanometres = 380; nanometres <= 780; nanometres += 4) {
      wavelengths.push_back(static_cast<float>(nanometres));
    }
  }
  Chart chart;
  chart.title = "Spectrum in the mirror direction";
  chart.x.label = "wavelength in nm";
  chart.y.label = "f in 1/sr";
  chart.y.is_logarithmic = true;
  for (const double view : views) {
    const auto values = reflectance::spectrum_of(brdf, Imath::V3d(direction_at(-view)),
                                                 Imath::V3d(direction_at(view)), wavelengths);
    Series& series = chart.series.emplace_back(Series{fmt::format("view {}\u00B0", view), {}, {}, {}});
    series.has_marks = is_data;
    for (std::size_t i = 0; i < values.size(); ++i) {
      series.points.emplace_back(double(wavelengths[i]), values[i]);
    }
  }
  return chart;
}

}  // namespace plot
