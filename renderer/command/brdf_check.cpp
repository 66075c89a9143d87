// `bpt brdf check` finds where a BRDF is not reciprocal, reflects more light than there is, or lacks data.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/command/brdf_command.h"
#include "renderer/command/json_values.h"
#include "renderer/command/printed.h"
#include "renderer/plot/brdf_charts.h"
#include "renderer/plot/colour_scale.h"
#include "renderer/plot/svg.h"
#include "renderer/reflectance/brdf_instance.h"
#include "renderer/reflectance/plausibility.h"
#include "renderer/studies/angles.h"

namespace command {
namespace {

using grf::Diagnostics;
using grf::ExitCode;
using plot::Point;
using plot::Rectangle;
using reflectance::AngleMap;
using reflectance::Plausibility;
using reflectance::Reflector;
using reflectance::Vec3f;

constexpr double PanelWidth = 460;
constexpr double PanelHeight = 330;

double theta_of(const Vec3f& d) { return std::acos(std::min(1.0, double(d.z))); }
double phi_of(const Vec3f& d) { return std::atan2(double(d.y), double(d.x)); }

nlohmann::ordered_json to_json(const Plausibility& found) {
  const reflectance::SwappedPair& pair = found.worst_pair;
  const auto angles = [](const Vec3f& d) { return nlohmann::ordered_json::array({theta_of(d), phi_of(d)}); };
  return {{"reciprocal", found.is_reciprocal()},
          {"mean_asymmetry", found.mean_asymmetry},
          {"worst_pair",
           {{"u", angles(pair.u)},
            {"v", angles(pair.v)},
            {"value", json_array(pair.value)},
            {"swapped", json_array(pair.swapped)}}},
          {"conserves_energy", found.conserves_energy()},
          {"largest_albedo", found.largest_albedo.albedo},
          {"largest_albedo_degrees", found.largest_albedo.degrees},
          {"missing_fraction", found.missing_fraction},
          {"negative_fraction", found.negative_fraction}};
}

std::string angles_text(const Vec3f& d) {
  return fmt::format("({:.0f}, {:.0f})", theta_of(d) / studies::Degree, phi_of(d) / studies::Degree);
}

void print(const Plausibility& found) {
  const auto verdict = [](bool is_good) { return is_good ? "ok     " : "warning"; };
  fmt::print("{} reciprocity: |f(u,v) - f(v,u)| is {:.2g} % of f on average\n",
             verdict(found.is_reciprocal()), 100 * found.mean_asymmetry);
  if (!found.is_reciprocal()) {
    const reflectance::SwappedPair& pair = found.worst_pair;
    fmt::print(
        "        most for u, v at (theta, phi) = {}, {} degrees: {:.4g} {:.4g} {:.4g} and {:.4g} {:.4g} "
        "{:.4g} 1/sr\n",
        angles_text(pair.u), angles_text(pair.v), pair.value.x, pair.value.y, pair.value.z, pair.swapped.x,
        pair.swapped.y, pair.swapped.z);
  }
  fmt::print("{} energy: at most {:.4g} of the light is reflected, at {:.0f} degrees\n",
             verdict(found.conserves_energy()), found.largest_albedo.albedo, found.largest_albedo.degrees);
  fmt::print("{} holes: {:.3g} % of the pairs of directions have no value in the file\n",
             verdict(found.missing_fraction == 0), 100 * found.missing_fraction);
  fmt::print("{} sign: {:.3g} % of the pairs of directions have a negative channel in the file\n",
             verdict(found.negative_fraction == 0), 100 * found.negative_fraction);
}

/// Draws a map in the colours of a scale from 0 to its largest value, with a bar.
void draw_map(const AngleMap& map, const std::string& title, const Rectangle& place, plot::Svg& svg) {
  plot::Chart chart;
  chart.title = title;
  chart.x = {"angle of the light, degrees", false, 0, 90, 30};
  chart.y = {"angle of the view, degrees", false, 0, 90, 30};
  const Rectangle panel = {place.corner, place.width - 90, place.height};
  const Rectangle area = plot::plot_area(chart, panel);
  double largest = 0;
  for (std::size_t i = 0; i < AngleMap::Side * AngleMap::Side; ++i)
    largest = std::max(largest, map.at(i / AngleMap::Side, i % AngleMap::Side));
  const plot::LinearColourScale scale(0, largest > 0 ? largest : 1,
                                      plot::LinearColourScale::Palette::Sequential);
  draw(chart, panel, svg);
  const double width = area.width / AngleMap::Side;
  const double height = area.height / AngleMap::Side;
  for (std::size_t view = 0; view < AngleMap::Side; ++view) {
    for (std::size_t light = 0; light < AngleMap::Side; ++light) {
      const Point corner(area.corner.x + width * static_cast<double>(light),
                         area.corner.y + area.height - height * static_cast<double>(view + 1));
      // Half a pixel more hides the seams.
      svg.rectangle(corner, width + 0.5, height + 0.5, plot::hexadecimal(scale.colour(map.at(view, light))));
    }
  }
  draw(scale, {{panel.corner.x + panel.width + 10, area.corner.y}, 16, area.height}, svg);
}

/// Draws the albedo, and where the two orders of the directions differ or data are missing or negative.
plot::Svg picture_of(const Reflector& reflector, const Plausibility& found, const std::string& title) {
  std::vector<std::pair<const AngleMap*, std::string>> maps = {
      {&found.asymmetry, "|f(u,v) - f(v,u)| as a part of f"}};
  if (found.missing_fraction > 0) maps.emplace_back(&found.missing, "Part of directions without a value");
  if (found.negative_fraction > 0)
    maps.emplace_back(&found.negative, "Part of directions with a negative channel");
  const std::size_t rows = (maps.size() + 2) / 2;
  plot::Svg svg(2 * PanelWidth + 60, 50 + static_cast<double>(rows) * PanelHeight);
  svg.text({20, 30}, title, {plot::fitting_size(17, title, 2 * PanelWidth), "#111", plot::Anchor::Start, 0});
  constexpr int Samples = 4096;
  draw(albedo_chart(plot::albedo_curve(reflector, Samples)), {{20, 50}, PanelWidth, PanelHeight - 20}, svg);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const Point corner(20 + (PanelWidth + 20) * static_cast<double>((i + 1) % 2),
                       50 + PanelHeight * static_cast<double>((i + 1) / 2));
    draw_map(*maps[i].first, maps[i].second, {corner, PanelWidth, PanelHeight - 20}, svg);
  }
  return svg;
}

}  // namespace

ExitCode check_brdf(const BrdfArguments& arguments) {
  const auto reflector = printed(
      [&](Diagnostics& diagnostics) { return reflectance::read_instance(arguments.instance, diagnostics); });
  if (!reflector) return ExitCode::BadInput;
  const Plausibility found = reflectance::check_plausibility(reflector->brdf());
  if (!arguments.output.empty()) {
    Diagnostics diagnostics;
    const bool is_written =
        plot::write_picture(picture_of(*reflector, found, arguments.instance), arguments.output, diagnostics);
    fmt::print(stderr, "{}", diagnostics.to_text());
    if (!is_written) return ExitCode::BadInput;
  }
  if (arguments.json) {
    fmt::print("{}\n", json_text(to_json(found), true));
  } else {
    print(found);
  }
  return ExitCode::Done;
}

}  // namespace command
