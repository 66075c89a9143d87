#include "renderer/studies/fit_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "grf/wording.h"
#include "grf/write.h"
#include "renderer/plot/chart.h"
#include "renderer/plot/fit_file.h"
#include "renderer/reflectance/brdf_instance.h"
#include "renderer/reflectance/model.h"
#include "renderer/studies/angles.h"
#include "renderer/studies/disc_plot.h"
#include "renderer/studies/lobe_figure.h"

namespace studies {
namespace {

using plot::Anchor;
using plot::Point;
using plot::Rectangle;
using reflectance::Vec3f;

constexpr double Width = 1040;
constexpr double Height = 620;
constexpr Rectangle LobePlace = {{20, 90}, 560, 500};
constexpr Rectangle DiscPlace = {{640, 96}, 220, 220};
constexpr Rectangle ChartPlace = {{610, 350}, 410, 250};

/// The relative difference to f above which a value is taken for wrong, or for something else than f. FIT
/// files of other programs have six digits.
constexpr double Differs = 1e-3;

constexpr std::array<std::string_view, 4> CloudColours = {"#d55e00", "#009e73", "#cc79a7", "#e69f00"};

struct FitPlotSettings {
  float azimuth = 60;
  float elevation = 25;
  bool logarithmic = false;
  bool cosine = false;

  static reflectance::ModelTable<FitPlotSettings> table() {
    using Self = FitPlotSettings;
    using reflectance::boolean_parameter;
    using reflectance::in_unit;
    using reflectance::number_parameter;
    return {.keyword = "fitplot",
            .title = "FIT plot",
            .parameters = {in_unit("deg", number_parameter(&Self::azimuth, "azimuth", -180, 180,
                                                           "azimuth of the eye, from the x axis")),
                           in_unit("deg", number_parameter(&Self::elevation, "elevation", 0, 89,
                                                           "elevation of the eye over the surface")),
                           boolean_parameter(&Self::logarithmic, "logarithmic",
                                             "a logarithmic radius, over five decades"),
                           boolean_parameter(&Self::cosine, "cosine",
                                             "the lobe is f cos, where the values of the file are that")},
            .description =
                "Plots the directions of FIT files with their values: in 3D over the lobe of the BRDF, on "
                "the unit disc, and against the BRDF's own values."};
  }
};

/// A point of a file, with the value that the BRDF has there.
struct ComparedPoint {
  Vec3f direction;
  double value = 0;
  double expected = 0;

  double difference() const {
    const double larger = std::max(std::abs(value), std::abs(expected));
    return larger > 0 ? std::abs(value - expected) / larger : 0;
  }
};

struct ReadFit {
  plot::FitFile file;
  reflectance::Brdf brdf;
  Vec3f u;
  std::string name;
  std::vector<ComparedPoint> points;
  std::size_t below = 0;  ///< directions at or below the horizon, which are left out
  std::size_t different = 0;
  double largest_difference = 0;
};

/// Evaluates the BRDF in the directions of a file.
void compare(ReadFit& fit, bool with_cosine) {
  for (const plot::FitPoint& point : fit.file.points) {
    if (!(point.direction.z > 0)) {
      ++fit.below;
      continue;
    }
    const Vec3f v = point.direction.normalized();
    const double f = reflectance::mean(reflectance::evaluate(fit.brdf, fit.u, v));
    fit.points.push_back({v, point.value, with_cosine ? f * v.z : f});
    const double difference = fit.points.back().difference();
    fit.different += difference > Differs ? 1 : 0;
    fit.largest_difference = std::max(fit.largest_difference, difference);
  }
}

std::optional<ReadFit> read(const ToolState::File& file, bool with_cosine, grf::Diagnostics& diagnostics) {
  const auto text = grf::read_file(file.path, diagnostics, file.location);
  auto fit = text ? plot::read_fit(*text, file.path, diagnostics) : std::nullopt;
  if (!fit) return std::nullopt;
  if (!(std::abs(fit->theta) < std::numbers::pi / 2)) {
    diagnostics.error(
        grf::whole_file(file.path),
        fmt::format("the view's theta, {}, is not above the surface: angles are in radians, below 1.5708",
                    fit->theta));
    return std::nullopt;
  }
  const auto brdf = reflectance::make_brdf(fit->brdf, diagnostics);
  if (!brdf) return std::nullopt;
  const Vec3f u = direction_of({fit->theta, fit->phi});
  ReadFit result{std::move(*fit), *brdf, u, grf::file_name(file.path), {}};
  compare(result, with_cosine);
  return result;
}

std::string_view colour_of(std::size_t index) { return CloudColours[index % CloudColours.size()]; }

std::string counted_directions(const ReadFit& fit) {
  return fit.name + ": " + grf::counted(fit.points.size(), "direction", "directions");
}

void draw_header(const std::vector<ReadFit>& fits, plot::Svg& svg) {
  const ReadFit& first = fits.front();
  const std::string brdf = grf::to_text(first.file.brdf);
  svg.text({20, 30}, brdf, {plot::fitting_size(17, brdf, Width - 40), "#111", Anchor::Start, 0});
  svg.text({20, 54}, viewed_text({first.file.theta, first.file.phi}), {13, "#333", Anchor::Start, 0});
  double x = 20;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const std::string words = counted_directions(fits[i]);
    svg.dots(std::array{Point(x + 4, 72)}, 4, colour_of(i));
    svg.text({x + 14, 76}, words, {11, "#333", Anchor::Start, 0});
    x += 34 + 6.8 * static_cast<double>(words.size());
  }
}

void draw_lobe_panel(const std::vector<ReadFit>& fits, const FitPlotSettings& settings,
                     const StudyContext& context, plot::Svg& svg) {
  std::vector<SampleCloud> clouds;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    clouds.push_back({{}, {}, colour_of(i)});
    for (const ComparedPoint& point : fits[i].points) {
      clouds.back().directions.push_back(point.direction);
      clouds.back().values.push_back(point.value);
    }
  }
  const SampledLobe lobe(fits.front().brdf, fits.front().u,
                         {plot::Channel::Mean, settings.cosine, settings.logarithmic}, std::move(clouds),
                         context.is_stopped);
  lobe.draw({settings.azimuth, settings.elevation, LobePlace}, svg);
  svg.text({LobePlace.corner.x, LobePlace.corner.y + LobePlace.height + 22},
           fmt::format("The lobe is {}: {}.", settings.cosine ? "f cos" : "f", lobe.scale_text()),
           {11, "#666", Anchor::Start, 0});
}

void draw_disc_panel(const std::vector<ReadFit>& fits, const FitPlotSettings& settings, plot::Svg& svg) {
  const ReadFit& first = fits.front();
  const DiscMap map([&](const Vec3f& v) {
    const double f = reflectance::mean(reflectance::evaluate(first.brdf, first.u, v));
    return settings.cosine ? f * v.z : f;
  });
  const plot::ColourScale scale(map.least(), map.largest());
  draw(map, scale, DiscPlace, svg);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    std::vector<Vec3f> directions;
    for (const ComparedPoint& point : fits[i].points) directions.push_back(point.direction);
    draw_directions(directions, DiscPlace, colour_of(i), svg);
  }
  mark_view(first.u, DiscPlace, svg);
  draw(scale,
       {{DiscPlace.corner.x + DiscPlace.width + 22, DiscPlace.corner.y + 12}, 12, DiscPlace.height - 24},
       svg);
  svg.text({DiscPlace.corner.x + DiscPlace.width + 22, DiscPlace.corner.y - 2}, "1/sr",
           {11, "#333", Anchor::Start, 0});
  svg.text({DiscPlace.corner.x, DiscPlace.corner.y - 10}, "Directions on the unit disc",
           {13, "#111", Anchor::Start, 0});
}

/// Plots the values of the files against those of the BRDF.
void draw_comparison(const std::vector<ReadFit>& fits, const FitPlotSettings& settings, plot::Svg& svg) {
  double least = 0;
  double largest = 0;
  for (const ReadFit& fit : fits) {
    for (const ComparedPoint& point : fit.points) {
      for (const double value : {point.value, point.expected}) {
        largest = std::max(largest, value);
        if (value > 0) least = least > 0 ? std::min(least, value) : value;
      }
    }
  }
  if (!(largest > 0)) return;
  least = std::max(least, largest * 1e-6);
  plot::Chart chart;
  chart.title = "Values of the file against the BRDF's own";
  chart.x = {settings.cosine ? "f cos of the BRDF, 1/sr" : "f of the BRDF, 1/sr", true, least / 1.3,
             largest * 1.3};
  chart.y = {"value of the file", true, least / 1.3, largest * 1.3};
  chart.series.push_back({"", {{least / 1.3, least / 1.3}, {largest * 1.3, largest * 1.3}}, "#999", "4 3"});
  for (std::size_t i = 0; i < fits.size(); ++i) {
    plot::Series series = {"", {}, colour_of(i)};
    series.has_line = false;
    for (const ComparedPoint& point : fits[i].points) {
      series.points.emplace_back(std::max(point.expected, least), std::max(point.value, least));
    }
    chart.series.push_back(std::move(series));
  }
  draw(chart, ChartPlace, svg);
}

std::string summary_of(const std::vector<ReadFit>& fits) {
  std::string text;
  for (const ReadFit& fit : fits) {
    if (!text.empty()) text += ' ';
    text += counted_directions(fit);
    if (fit.below > 0) text += fmt::format(", {} more not above the surface", fit.below);
    text += fit.different == 0 ? fmt::format("; all values agree with the BRDF within {:.2g}.",
                                             std::max(fit.largest_difference, 1e-7))
                               : fmt::format("; {} from the BRDF by more than {}, at most by {:.3g}.",
                                             grf::counted(fit.different, "value differs", "values differ"),
                                             Differs, fit.largest_difference);
  }
  return text;
}

std::string csv_of(const std::vector<ReadFit>& fits) {
  std::string text = "file,x,y,z,value,f\n";
  for (const ReadFit& fit : fits) {
    for (const ComparedPoint& point : fit.points) {
      const Vec3f& v = point.direction;
      text += fmt::format("{},{},{},{},{},{}\n", fit.name, v.x, v.y, v.z, static_cast<float>(point.value),
                          static_cast<float>(point.expected));
    }
  }
  return text;
}

/// Describes the direction that is nearest to a point on the disc.
std::string described(const std::vector<ReadFit>& fits, const Point& at) {
  constexpr double Near = 6;
  const ComparedPoint* nearest = nullptr;
  double distance = Near;
  for (const ReadFit& fit : fits) {
    for (const ComparedPoint& point : fit.points) {
      const double away = (point_on_disc(point.direction.x, point.direction.y, DiscPlace) - at).length();
      if (away >= distance) continue;
      distance = away;
      nearest = &point;
    }
  }
  if (nearest == nullptr) return {};
  const Vec3f& v = nearest->direction;
  return fmt::format("\u03B8 = {:.4g}\u00B0, \u03C6 = {:.4g}\u00B0: value {:.5g}, the BRDF's own {:.5g} 1/sr",
                     std::acos(std::min(v.z, 1.0F)) / Degree, std::atan2(v.y, v.x) / Degree, nearest->value,
                     nearest->expected);
}

std::optional<Study> make_study(const ToolState& state, const StudyContext& context,
                                grf::Diagnostics& diagnostics) {
  const auto settings = reflectance::make<FitPlotSettings>(state.settings);
  if (state.files.empty()) {
    diagnostics.error(state.settings.location,
                      "no FIT file is open: open one, or name it as 'file NAME.fit'");
    return std::nullopt;
  }
  auto fits = std::make_shared<std::vector<ReadFit>>();
  for (const ToolState::File& file : state.files) {
    auto fit = read(file, settings.cosine, diagnostics);
    if (!fit) return std::nullopt;
    fits->push_back(std::move(*fit));
  }
  plot::Svg svg(Width, Height, context.paper);
  draw_header(*fits, svg);
  draw_lobe_panel(*fits, settings, context, svg);
  draw_disc_panel(*fits, settings, svg);
  draw_comparison(*fits, settings, svg);
  Study study{std::move(svg), summary_of(*fits), csv_of(*fits), plot::to_text(fits->front().file)};
  study.describe = [fits](const Point& point) { return described(*fits, point); };
  return study;
}

}  // namespace

StudyTool fit_plot_tool() {
  StudyTool tool;
  tool.settings = reflectance::info_of<FitPlotSettings>();
  tool.initial.settings.keyword = tool.settings.keyword;
  tool.files = "fit";
  tool.takes_many_files = true;
  tool.needs_file = true;
  tool.azimuth = "azimuth";
  tool.elevation = "elevation";
  tool.make = make_study;
  return tool;
}

}  // namespace studies
