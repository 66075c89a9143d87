#include "renderer/command/brdf_plot.h"

#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "renderer/command/lit_sphere.h"
#include "renderer/plot/chart.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/transport/image.h"

namespace command {
namespace {

using plot::Point;
using reflectance::Reflector;
using reflectance::Rgb;
using reflectance::Vec3f;

constexpr double Width = 980;
constexpr double Height = 660;
constexpr int SphereSide = 180;
constexpr std::array<int, 4> ViewAngles = {0, 30, 60, 80};

Vec3f direction_at(double degrees) {
  const double theta = degrees * std::numbers::pi / 180;
  return Vec3f(static_cast<float>(std::sin(theta)), 0, static_cast<float>(std::cos(theta)));
}

std::string name_of_view(int degrees) { return fmt::format("view {}\u00B0", degrees); }

/// The value over the light's angle. The mirror direction is at the view's own angle on the other side.
plot::Series curve(const Reflector& reflector, int view, bool with_cosine) {
  constexpr double Step = 0.1;
  plot::Series series{name_of_view(view), {}, {}};
  const Vec3f u = direction_at(-view);
  for (double degrees = -90 + Step / 2; degrees < 90; degrees += Step) {
    const Vec3f v = direction_at(degrees);
    const double value = reflectance::mean(reflector.evaluate(u, v));
    series.points.emplace_back(degrees, with_cosine ? value * v.z : value);
  }
  return series;
}

plot::Chart cartesian(const Reflector& reflector) {
  plot::Chart chart{"BRDF in the plane of incidence",
                    {"light angle in degrees; the view is on the left", false, -90, 90, 30},
                    {"f in 1/sr", true, {}, {}, 0},
                    {}};
  for (const int view : ViewAngles) chart.series.push_back(curve(reflector, view, false));
  return chart;
}

plot::PolarChart polar(const Reflector& reflector) {
  plot::PolarChart chart{"BRDF times cosine of the light", "f cos in 1/sr", {}};
  for (const int view : ViewAngles) chart.series.push_back(curve(reflector, view, true));
  return chart;
}

plot::Chart albedo_chart(const Reflector& reflector) {
  constexpr int Samples = 4096;
  plot::Chart chart{
      "Albedo", {"view angle in degrees", false, 0, 90, 15}, {"share reflected", false, 0, {}, 0}, {}};
  constexpr std::array<const char*, 3> Names = {"red", "green", "blue"};
  constexpr std::array<std::string_view, 3> Colours = {"#d55e00", "#009e73", "#0072b2"};
  std::array<plot::Series, 3> channels;
  bool is_grey = true;
  double largest = 1;
  for (int degrees = 0; degrees <= 89; ++degrees) {
    const Rgb value = reflectance::albedo(reflector, direction_at(degrees), Samples);
    is_grey = is_grey && value.x == value.y && value.y == value.z;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      channels[i].name = Names[i];
      channels[i].colour = Colours[i];
      channels[i].points.emplace_back(degrees, value[static_cast<int>(i)]);
      largest = std::max<double>(largest, value[static_cast<int>(i)]);
    }
  }
  chart.y.maximum = largest;
  if (is_grey) {
    chart.series = {{{}, channels[0].points, {}}};
  } else {
    chart.series.assign(channels.begin(), channels.end());
  }
  return chart;
}

std::string png_of(const transport::Image& image) {
  for (const transport::ImageFormat& format : transport::image_formats()) {
    if (format.extension == "png") return format.encode(image);
  }
  return {};
}

}  // namespace

plot::Svg picture_of(const Reflector& reflector, const std::string& title) {
  plot::Svg svg(Width, Height);
  svg.text({20, 30}, title, {17, "#111", plot::Anchor::Start, 0});
  draw(polar(reflector), {{20, 50}, 460, 280}, svg);
  draw(cartesian(reflector), {{500, 50}, 460, 280}, svg);
  draw(albedo_chart(reflector), {{20, 350}, 460, 290}, svg);
  svg.text({562, 364}, "Sphere, under a bright window and a dim sky", {13, "#111", plot::Anchor::Start, 0});
  svg.image({600, 385}, 220, 220, png_of(lit_sphere(reflector, SphereSide)));
  return svg;
}

}  // namespace command
