#include "renderer/command/brdf_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "renderer/command/directions.h"
#include "renderer/command/lit_sphere.h"
#include "renderer/plot/chart.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/light_angles.h"
#include "renderer/transport/image/image_encoders.h"

namespace command {
namespace {

using plot::Point;
using reflectance::Reflector;
using reflectance::Rgb;
using reflectance::Vec3f;

constexpr double Width = 980;
constexpr double Height = 660;
constexpr int SphereSide = 200;
constexpr std::array<int, 4> ViewAngles = {0, 30, 60, 80};

Vec3f direction_at(double degrees, double azimuth = 0) {
  constexpr double Radian = std::numbers::pi / 180;
  return direction_of({degrees * Radian, azimuth * Radian});
}

std::string name_of_view(int degrees) { return fmt::format("view {}\u00B0", degrees); }

/// The value over the light's angle. The mirror direction is at the view's own angle on the other side.
plot::Series curve(const Reflector& reflector, int view, bool with_cosine) {
  plot::Series series{name_of_view(view), {}, {}, {}};
  const Vec3f u = direction_at(-view);
  for (const double degrees : reflectance::light_angles(view)) {
    const Vec3f v = direction_at(degrees);
    const double value = reflectance::mean(reflector.evaluate(u, v));
    series.points.emplace_back(degrees, with_cosine ? value * v.z : value);
  }
  return series;
}

double peak_of(const plot::Series& series) {
  double peak = 0;
  for (const Point& point : series.points) peak = std::max(peak, point.y);
  return peak;
}

plot::Chart cartesian(const Reflector& reflector) {
  constexpr double Shown = 1e-6;  // of the peak
  plot::Chart chart{"BRDF in the plane of incidence",
                    {"light angle in degrees; the view is on the left", false, -90, 90, 30},
                    {"f in 1/sr", true, {}, {}, 0},
                    {}};
  double peak = 0;
  double lowest = std::numeric_limits<double>::infinity();
  for (const int view : ViewAngles) {
    chart.series.push_back(curve(reflector, view, false));
    peak = std::max(peak, peak_of(chart.series.back()));
    for (const Point& point : chart.series.back().points) {
      if (point.y > 0) lowest = std::min(lowest, point.y);
    }
  }
  if (!(peak > 0)) chart.title += ": 0, but for the mirror direction";
  if (peak > 0 && lowest < Shown * peak) chart.y.minimum = std::pow(10, std::floor(std::log10(Shown * peak)));
  return chart;
}

/// The Dirac part of a view, as a line that is as long as its weight.
plot::Series mirror_line(const Reflector& reflector, std::size_t index) {
  const int view = ViewAngles[index];
  const double weight = reflectance::mean(reflectance::mirror(reflector.brdf(), direction_at(-view)));
  return {{}, {Point(view, 0), Point(view, weight)}, plot::colour_of_series(index), "5 3"};
}

/// Lobes that are far longer than another are cut, so that all can be seen.
plot::PolarChart polar(const Reflector& reflector) {
  constexpr double TooLong = 8;  // times the shortest
  constexpr double Longest = 4;
  plot::PolarChart chart{"BRDF times cosine of the light", "f cos in 1/sr", {}, {}, {}, {}};
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0;
  for (const int view : ViewAngles) {
    chart.series.push_back(curve(reflector, view, true));
    shortest = std::min(shortest, peak_of(chart.series.back()));
    longest = std::max(longest, peak_of(chart.series.back()));
  }
  if (shortest > 0 && longest > TooLong * shortest) chart.maximum = Longest * shortest;
  for (std::size_t i = 0; i < ViewAngles.size(); ++i) {
    constexpr double Seen = 0.005;
    const plot::Series line = mirror_line(reflector, i);
    if (peak_of(line) > Seen) chart.shares.push_back(line);
  }
  if (!chart.shares.empty()) chart.note = "dashed: the mirror part, all of the light at the outermost ring";
  return chart;
}

/// Of each channel, or of all in one where they are equal.
std::vector<plot::Series> albedo_curves(const Reflector& reflector, double azimuth) {
  constexpr int Samples = 4096;
  constexpr std::array<const char*, 3> Names = {"red", "green", "blue"};
  constexpr std::array<std::string_view, 3> Colours = {"#d55e00", "#009e73", "#0072b2"};
  std::vector<plot::Series> channels;
  for (std::size_t i = 0; i < 3; ++i) channels.push_back({Names[i], {}, Colours[i], {}});
  bool is_grey = true;
  for (int degrees = 0; degrees < 90; degrees += degrees < 70 ? 2 : 1) {
    const Rgb value = reflectance::albedo(reflector, direction_at(degrees, azimuth), Samples);
    is_grey = is_grey && value.x == value.y && value.y == value.z;
    for (std::size_t i = 0; i < 3; ++i) channels[i].points.emplace_back(degrees, value[static_cast<int>(i)]);
  }
  if (is_grey) return {{"albedo", channels[0].points, plot::colour_of_series(0), {}}};
  return channels;
}

plot::Chart albedo_chart(const Reflector& reflector) {
  constexpr double Highest = 2;  // that is drawn
  plot::Chart chart{
      "Albedo", {"view angle in degrees", false, 0, 90, 15}, {"share reflected", false, 0, {}, 0}, {}};
  chart.series = albedo_curves(reflector, 0);
  if (reflectance::is_anisotropic(reflector.brdf())) {
    for (plot::Series& series : chart.series) series.name += ", along x";
    for (plot::Series& series : albedo_curves(reflector, 90)) {
      series.name += ", along y";
      series.dashes = "5 3";
      chart.series.push_back(series);
    }
  }
  double largest = 0;
  for (const plot::Series& series : chart.series) largest = std::max(largest, peak_of(series));
  chart.y.maximum = std::clamp(largest, 1.0, Highest);
  if (largest > 1.002) {
    chart.title += fmt::format(": up to {:.3g}, more than is received", largest);
    chart.series.push_back({{}, {Point(0, 1), Point(90, 1)}, "#111", "2 3"});
  }
  return chart;
}

}  // namespace

plot::Svg picture_of(const Reflector& reflector, const std::string& title) {
  plot::Svg svg(Width, Height);
  const double fitting = (Width - 40) / (0.62 * static_cast<double>(std::max<std::size_t>(1, title.size())));
  svg.text({20, 30}, title, {std::min(17.0, fitting), "#111", plot::Anchor::Start, 0});
  draw(polar(reflector), {{20, 50}, 460, 280}, svg);
  draw(cartesian(reflector), {{500, 50}, 460, 280}, svg);
  draw(albedo_chart(reflector), {{20, 350}, 460, 290}, svg);
  svg.text({562, 364}, "Sphere, under a bright window and a dim sky", {13, "#111", plot::Anchor::Start, 0});
  svg.image({600, 385}, 220, 220, transport::encode_png({lit_sphere(reflector, SphereSide)}));
  return svg;
}

}  // namespace command
