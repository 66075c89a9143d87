#include "renderer/studies/environment/figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "grf/srgb.h"
#include "grf/write.h"
#include "renderer/plot/brdf_charts.h"
#include "renderer/plot/colour_scale.h"
#include "renderer/studies/angles.h"

namespace studies {
namespace {

using plot::Anchor;
using plot::Point;
using plot::Rectangle;
using reflectance::mean;
using reflectance::Rgb;
using reflectance::Vec3f;
using Show = EnvironmentSettings::Show;

/// Of the histogram, lighter than its outline.
constexpr std::string_view BarColour = "#a8c8e4";
constexpr double Width = 1040;
constexpr double Height = 620;
constexpr double Left = 20;
const Point SphereCentre(186, 276);
constexpr double SphereRadius = 152;
constexpr Rectangle MapPlace = {{415, 106}, 520, 260};
constexpr Rectangle BarPlace = {{953, 116}, 12, 240};
constexpr Rectangle WeightPlace = {{353, 404}, 292, 212};
constexpr Rectangle DeviationPlace = {{650, 404}, 386, 212};
constexpr double NumbersTop = 462;

constexpr std::string_view CandidateColour = "#e69f00";
constexpr std::string_view HiddenCandidate = "#e8cf9c";
constexpr std::string_view SampleColour = "#d6006e";
constexpr std::string_view HiddenSample = "#e3a0c2";
// Near-greys, which stay as they are on dark paper.
constexpr std::string_view DarkRim = "#3a3a3b";
constexpr std::string_view LightRim = "#fffffe";
constexpr double CandidateRadius = 1.3;
constexpr double SampleRadius = 1.8;  // of one that was chosen once; the area is in proportion to copies
constexpr int MostCopies = 6;

UnrolledView unrolled() { return UnrolledView(MapPlace); }
SphereView sphere_of(const EnvironmentSettings& settings) {
  return {settings.azimuth, settings.elevation, SphereCentre, SphereRadius};
}

std::string_view title_of(const EnvironmentSettings& settings) {
  switch (settings.shown()) {
    case Show::Map:
      return settings.is_luminance() ? "Luminance of the environment map" : "Environment map";
    case Show::FCos:
      return "BRDF: density in proportion to f cos";
    case Show::Light:
      return "Map: density of sampling by luminance";
    case Show::Warps:
      return "Map: density of sampling for this normal";
    case Show::Product:
      return "Product: density in proportion to f cos L";
    case Show::Scheme:
      return "Scheme: density of the candidates";
    case Show::Lost:
      return "Product over candidates: how many times too few there are";
  }
  return {};
}

/// The picture of what is shown, with its colour scale unless it shows colours themselves.
struct Picture {
  ColouredSphere sphere;
  std::optional<plot::ColourScale> scale;
  std::string_view unit;
};

/// Maps values to false colours. Where there is nothing it is grey.
Picture false_colours(const SphereGrid& grid, const std::vector<double>& values, double least,
                      std::string_view unit, const plot::Svg& svg) {
  double lowest = 0;
  double highest = 0;
  for (const double value : values) {
    if (!(value > 0) || !std::isfinite(value)) continue;
    lowest = lowest > 0 ? std::min(lowest, value) : value;
    highest = std::max(highest, value);
  }
  const plot::ColourScale scale(std::max(lowest, least), highest);
  const Rgb absent = grf::srgb_decoded(svg.shaded(grf::Colour(0.82F)));
  std::array<Rgb, 512> shades;
  const double range = std::log(scale.highest() / scale.lowest());
  for (std::size_t i = 0; i < shades.size(); ++i) {
    const double fraction = static_cast<double>(i) / (shades.size() - 1);
    shades[i] = grf::srgb_decoded(scale.colour(scale.lowest() * std::exp(range * fraction)));
  }
  const auto shade_of = [&](double value) {
    const double fraction = std::log(std::max(value, scale.lowest()) / scale.lowest()) / range;
    return shades[static_cast<std::size_t>(std::lround(std::min(fraction, 1.0) * (shades.size() - 1)))];
  };
  Picture picture{{grid, {}}, scale, unit};
  picture.sphere.colours.reserve(values.size());
  for (const double value : values) picture.sphere.colours.push_back(value > 0 ? shade_of(value) : absent);
  return picture;
}

Picture map_picture(const EnvironmentResult& result, const plot::Svg& svg) {
  const std::vector<Rgb>& cells = result.surface.environment->cells;
  if (result.settings.is_luminance()) {
    std::vector<double> values;
    for (const Rgb& cell : cells) values.push_back(plot::channel_of(cell, plot::Channel::Luminance));
    return false_colours(FilteredMap::Grid, values, 0, "L", svg);
  }
  Picture picture{{FilteredMap::Grid, cells}, std::nullopt, {}};
  const float factor = std::exp2(result.settings.exposure);
  for (Rgb& colour : picture.sphere.colours) colour *= factor;
  return picture;
}

double value_of(const DirectionValues& cell, Show show) {
  switch (show) {
    case Show::FCos:
      return cell.brdf;
    case Show::Light:
      return cell.map;
    case Show::Warps:
      return cell.warps;
    case Show::Product:
      return cell.product;
    case Show::Scheme:
      return cell.scheme;
    default:
      return cell.product > 0 ? cell.product / cell.scheme : 0;
  }
}

Picture picture_of(const EnvironmentResult& result, const plot::Svg& svg) {
  const Show show = result.settings.shown();
  if (show == Show::Map) return map_picture(result, svg);
  std::vector<double> values;
  for (const DirectionValues& cell : result.quadrature.cells()) values.push_back(value_of(cell, show));
  return false_colours(SurfaceQuadrature::Grid, values, show == Show::Lost ? 1 : 0,
                       show == Show::Lost ? "ratio" : "1/sr", svg);
}

/// Draws candidates and samples in any of the two views.
template <class View>
void draw_candidates(const EnvironmentResult& result, const View& view, plot::Svg& svg) {
  std::vector<Vec3f> all;
  std::array<std::vector<Vec3f>, MostCopies> chosen;
  for (const Candidate& candidate : result.light.candidates) {
    if (!(candidate.pdf > 0) && !candidate.is_specular) continue;
    all.push_back(result.to_map(candidate.v));
    if (candidate.copies == 0) continue;
    chosen[static_cast<std::size_t>(std::min(candidate.copies, MostCopies) - 1)].push_back(all.back());
  }
  if (result.settings.has_candidates())
    draw_dots(all, {CandidateRadius, CandidateColour, HiddenCandidate, DarkRim}, view, svg);
  for (std::size_t i = MostCopies; result.settings.has_samples() && i-- > 0;) {
    const double radius = SampleRadius * std::sqrt(static_cast<double>(i + 1));
    draw_dots(chosen[i], {radius, SampleColour, HiddenSample, LightRim}, view, svg);
  }
}

void draw_ring(const Point& at, double radius, plot::Svg& svg) {
  svg.circle(at, radius, {LightRim, 3});
  svg.circle(at, radius, {DarkRim, 1.3});
}

void draw_cross(const Point& at, plot::Svg& svg) {
  for (const auto& [colour, width] : {std::pair(LightRim, 3.4), std::pair(DarkRim, 1.5)}) {
    svg.line(at - Point(5, 5), at + Point(5, 5), {colour, width});
    svg.line(at - Point(5, -5), at + Point(5, -5), {colour, width});
  }
}

/// Marks the eye and its mirror direction, the latter by a cross.
void draw_marks(const EnvironmentResult& result, const SphereView& view, plot::Svg& svg) {
  const Vec3f eye = result.to_map(result.surface.u);
  const Vec3f mirror = result.to_map(reflectance::mirrored(result.surface.u));
  if (view.is_in_front(eye)) draw_ring(view.point(eye), 5, svg);
  if (view.is_in_front(mirror)) draw_cross(view.point(mirror), svg);
}

void draw_marks(const EnvironmentResult& result, const UnrolledView& view, plot::Svg& svg) {
  const Point eye = view.point(result.to_map(result.surface.u));
  const Point mirror = view.point(result.to_map(reflectance::mirrored(result.surface.u)));
  // A mark at one side goes on at the other.
  for (const double turn : {-1.0, 0.0, 1.0}) {
    const Point away(turn * view.place().width, 0);
    draw_ring(eye + away, 5, svg);
    draw_cross(mirror + away, svg);
  }
}

/// Draws a direction as a line out of the sphere, with its name in a light disc, as it may be before the
/// sphere.
void draw_axis(const Vec3f& direction, std::string_view name, double length, const SphereView& view,
               plot::Svg& svg) {
  if (!view.is_in_front(direction)) return;
  const Point end = view.point(direction * static_cast<float>(length));
  const std::array<Point, 1> dot = {end};
  svg.line(view.point(direction), end, {LightRim, 3});
  svg.line(view.point(direction), end, {"#888", 1.2});
  const double radius = name.size() > 1 ? 10 : 8;
  svg.dots(dot, radius + 0.8, "#888");
  svg.dots(dot, radius, "#fff");
  svg.text(end + Point(0, 4), name, {11, "#111", Anchor::Middle, 0});
}

void draw_sphere_panel(const EnvironmentResult& result, plot::Svg& svg) {
  const SphereView view = sphere_of(result.settings);
  svg.circle(view.centre(), view.radius(), {"#888", 1});
  const Vec3f& normal = result.surface.frame.z;
  draw_horizon(normal, view, svg);
  draw_candidates(result, view, svg);
  draw_marks(result, view, svg);
  constexpr std::array<std::pair<Vec3f, std::string_view>, 6> Axes = {{{{1, 0, 0}, "x"},
                                                                       {{0, 1, 0}, "y"},
                                                                       {{0, 0, 1}, "z"},
                                                                       {{-1, 0, 0}, "\u2212x"},
                                                                       {{0, -1, 0}, "\u2212y"},
                                                                       {{0, 0, -1}, "\u2212z"}}};
  for (const auto& [direction, name] : Axes) {
    if (direction.dot(normal) < 0.95F) draw_axis(direction, name, 1.12, view, svg);
  }
  draw_axis(normal, "n", 1.28, view, svg);
}

void draw_map_panel(const EnvironmentResult& result, const Picture& picture, plot::Svg& svg) {
  const UnrolledView view = unrolled();
  const Rectangle& place = view.place();
  svg.begin_clip(place.corner, place.width, place.height);
  draw_horizon(result.surface.frame.z, view, svg);
  draw_candidates(result, view, svg);
  draw_marks(result, view, svg);
  svg.end_clip();
  draw_axes(view, svg);
  svg.text(place.corner - Point(0, 9), title_of(result.settings), {13, "#111", Anchor::Start, 0});
  if (!picture.scale) return;
  draw(*picture.scale, BarPlace, svg);
  svg.text(BarPlace.corner - Point(0, 8), picture.unit, {11, "#333", Anchor::Start, 0});
}

void draw_header(const EnvironmentResult& result, plot::Svg& svg) {
  const EnvironmentSettings& settings = result.settings;
  const image::Image& image = result.surface.map().image();
  const std::string brdf = grf::to_text(result.model);
  svg.text({Left, 30}, brdf, {plot::fitting_size(17, brdf, Width - 2 * Left), "#111", Anchor::Start, 0});
  const std::string normal = settings.tilt == 0
                                 ? std::string("the normal is y")
                                 : fmt::format("the normal is tilted {} from y towards azimuth {}",
                                               degrees_text(settings.tilt), degrees_text(settings.heading));
  svg.text({Left, 54},
           fmt::format("{}; {}; under {}, {} \u00D7 {} texels",
                       viewed_text({settings.theta * Degree, settings.phi * Degree}), normal,
                       result.surface.environment->name, image.width, image.height),
           {13, "#333", Anchor::Start, 0});
}

/// Draws the legend of the dots and marks in one line above the sphere.
void draw_legend(const EnvironmentResult& result, plot::Svg& svg) {
  constexpr double Line = 78;
  double x = Left;
  const auto item = [&](std::string_view words) {
    svg.text({x + 10, Line}, words, {11, "#333", Anchor::Start, 0});
    x += 28 + 5.75 * static_cast<double>(words.size());
  };
  const std::array<Point, 1> candidate = {Point(x + 2, Line - 4)};
  svg.dots(candidate, CandidateRadius + 1.6, DarkRim);
  svg.dots(candidate, CandidateRadius + 0.8, CandidateColour);
  item(fmt::format("N = {} candidates", result.light.candidates.size()));
  const std::array<Point, 1> sample = {Point(x + 2, Line - 4)};
  svg.dots(sample, SampleRadius + 1.2, SampleColour);
  item(fmt::format("M = {} samples, larger if chosen again", result.settings.counts().chosen));
  draw_ring({x, Line - 4}, 4, svg);
  item("eye");
  svg.line({x - 4, Line - 8}, {x + 4, Line}, {"#333", 1.5});
  svg.line({x - 4, Line}, {x + 4, Line - 8}, {"#333", 1.5});
  item("mirror");
  svg.line({x - 4, Line - 4}, {x + 12, Line - 4}, {"#333", 1.2, "4 3"});
  x += 8;
  item("horizon");
}

void draw_weights(const EnvironmentResult& result, plot::Svg& svg) {
  constexpr int Bins = 30;
  const auto count = static_cast<double>(result.light.candidates.size());
  double average = 0;
  for (const Candidate& candidate : result.light.candidates) average += candidate.weight() / count;
  double low = -1;
  double high = 1;
  std::vector<double> exponents;
  for (const Candidate& candidate : result.light.candidates) {
    if (!(candidate.weight() > 0)) continue;
    exponents.push_back(std::log10(candidate.weight() / average));
    high = std::max(high, std::ceil(exponents.back()));
    low = std::clamp(std::floor(exponents.back()), high - 6, low);
  }
  std::array<int, Bins> heights = {};
  for (const double exponent : exponents) {
    const double place = (exponent - low) / (high - low) * Bins;
    ++heights[static_cast<std::size_t>(std::clamp(place, 0.0, Bins - 1.0))];
  }
  plot::Series bars;
  bars.fill = BarColour;
  bars.points.emplace_back(std::pow(10, low), 0);
  for (int bin = 0; bin < Bins; ++bin) {
    for (const int end : {bin, bin + 1}) {
      bars.points.emplace_back(std::pow(10, low + (high - low) * end / Bins),
                               heights[static_cast<std::size_t>(bin)]);
    }
  }
  bars.points.emplace_back(std::pow(10, high), 0);
  plot::Chart chart;
  const std::size_t zero = result.light.rejected();
  chart.title =
      zero > 0 ? fmt::format("Weights of candidates; {} of weight 0", zero) : "Weights of candidates";
  chart.x = {"weight over its mean", true, std::pow(10, low), std::pow(10, high)};
  chart.y = {"candidates", false, 0, std::max(1, *std::ranges::max_element(heights)) * 1.08};
  chart.series.push_back(std::move(bars));
  draw(chart, WeightPlace, svg);
}

void draw_deviations(const EnvironmentResult& result, plot::Svg& svg) {
  if (result.deviations.empty()) return;
  plot::Chart chart;
  chart.title = "Deviation of estimates";
  switch (result.settings.visibility) {
    case 1:
      chart.title += "; a checker hides half";
      break;
    case 2:
      chart.title += "; x < 0 is hidden";
      break;
    default:
      chart.title += "; nothing is hidden";
  }
  for (const Deviation& deviation : result.deviations) {
    const std::string name = fmt::format("M = {}", deviation.counts.chosen);
    const auto known = std::ranges::find(chart.series, name, &plot::Series::name);
    plot::Series& series = known != chart.series.end() ? *known : chart.series.emplace_back();
    series.name = name;
    series.has_marks = true;
    if (deviation.relative > 0) series.points.emplace_back(deviation.counts.candidates, deviation.relative);
  }
  double least = 0;
  double largest = 0;
  for (const Deviation& deviation : result.deviations) {
    if (!(deviation.relative > 0)) continue;
    least = least > 0 ? std::min(least, deviation.relative) : deviation.relative;
    largest = std::max(largest, deviation.relative);
  }
  chart.x = {"candidates N", true, 3, 1400};
  chart.y = {"relative std deviation", true, least / 1.4, largest * 1.4};
  chart.has_names_at_ends = true;
  if (largest > 0) return draw(chart, DeviationPlace, svg);
  svg.text(DeviationPlace.corner + Point(62, 14), "Deviation of estimates: none",
           {13, "#111", Anchor::Start, 0});
}

std::string text_of(const Rgb& rgb) {
  constexpr std::size_t Fitting = 29;
  std::string average = fmt::format("{:.4g}", mean(rgb));
  if (std::abs(rgb.x - rgb.y) + std::abs(rgb.y - rgb.z) <= 1e-5F * mean(rgb)) return average;
  std::string text = fmt::format("{} ({:.3g}, {:.3g}, {:.3g})", average, rgb.x, rgb.y, rgb.z);
  return text.size() <= Fitting ? text : average;
}

void draw_numbers(const EnvironmentResult& result, plot::Svg& svg) {
  const double count = static_cast<double>(result.light.candidates.size());
  const double effective = result.light.effective_candidates();
  const double error = 100 * result.relative_error();
  const std::array<std::pair<std::string, std::string>, 8> rows = {
      {{"Effective candidates",
        fmt::format("{:.4g} of {:.0f}, {:.3g} %", effective, count, 100 * effective / count)},
       {"Effective, expected", fmt::format("{:.3g} %", 100 * result.quadrature.expected_efficiency())},
       {"Largest weight / mean", fmt::format("{:.3g}", result.light.largest_weight())},
       {"Radiance, resampled", text_of(result.light.estimate)},
       {"Radiance, quadrature", text_of(result.reflected)},
       {"Relative error", fmt::format("{}{:.3g} %", error < 0 ? "\u2212" : "+", std::abs(error))},
       {"Albedo", text_of(result.albedo)},
       {"Light missed",
        fmt::format("{:.3g} % (10\u00D7 too few)", 100 * result.quadrature.missed_light(10))}}};
  double y = NumbersTop;
  for (const auto& [name, value] : rows) {
    svg.text({Left, y}, name, {12, "#666", Anchor::Start, 0});
    svg.text({Left + 150, y}, value, {12, "#111", Anchor::Start, 0});
    y += 20;
  }
}

}  // namespace

plot::Svg environment_figure(const EnvironmentResult& result, plot::Paper paper) {
  plot::Svg svg(Width, Height, paper);
  const Picture picture = picture_of(result, svg);
  draw_header(result, svg);
  draw_legend(result, svg);
  draw(picture.sphere, sphere_of(result.settings), unrolled(), svg);
  draw_sphere_panel(result, svg);
  draw_map_panel(result, picture, svg);
  draw_numbers(result, svg);
  draw_weights(result, svg);
  draw_deviations(result, svg);
  return svg;
}

std::optional<Vec3f> direction_in_figure(const EnvironmentSettings& settings, const Point& point) {
  const auto direction = unrolled().direction(point);
  return direction ? direction : sphere_of(settings).direction(point);
}

}  // namespace studies
