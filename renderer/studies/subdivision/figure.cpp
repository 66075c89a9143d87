#include "renderer/studies/subdivision/figure.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>

#include "grf/write.h"
#include "renderer/plot/chart.h"
#include "renderer/plot/colour_scale.h"
#include "renderer/plot/lobe_mesh.h"
#include "renderer/studies/disc_plot.h"
#include "renderer/studies/lobe_figure.h"
#include "renderer/studies/subdivision/strata_panel.h"

namespace studies {
namespace {

using plot::Anchor;
using plot::Point;
using plot::Rectangle;
using reflectance::Vec3f;
using Cell = Subdivision::Cell;

constexpr Rectangle TreePlace = {{86, 110}, 420, 420};
constexpr Rectangle LobePlace = {{610, 116}, 410, 276};
constexpr Point LobeTitleAt = {610, 96};
constexpr Rectangle StrataPlace = {{610, 424}, 410, 176};

constexpr std::string_view WayColour = "#d81b80";
constexpr std::string_view UntestedColour = "#e4e4e4";
constexpr double MostDeviation = 4;

constexpr plot::Lettering Title = {13, "#111", Anchor::Start, 0};
constexpr plot::Lettering Small = {11, "#333", Anchor::Start, 0};

Point on_disc(double x, double y) { return point_on_disc(x, y, TreePlace); }

Point centre() { return on_disc(0, 0); }

std::array<Point, 4> outline_of(const Subdivision& tree, const reflectance::CellRange& range) {
  std::array<Point, 4> corners = tree.corners(range);
  for (Point& corner : corners) corner = on_disc(corner.x, corner.y);
  return corners;
}

double deviation(const CellSamples& samples, std::size_t cell) {
  return (samples.counted[cell] - samples.expected[cell]) / std::sqrt(samples.expected[cell]);
}

/// Fills each cell with a colour, under a bar of the scale.
template <class Scale>
void fill_cells(const Subdivision& tree, const Scale& scale,
                const std::function<std::optional<double>(std::size_t)>& value, plot::Svg& svg) {
  svg.begin_clip(centre(), TreePlace.width / 2);
  for (std::size_t i = 0; i < tree.cells().size(); ++i) {
    const auto known = value(i);
    svg.polygon(outline_of(tree, tree.cells()[i].range),
                known ? plot::hexadecimal(scale.colour(*known)) : std::string(UntestedColour), 0.4);
  }
  svg.end_clip();
}

template <class Scale>
void draw_bar(const Scale& scale, const std::vector<std::string>& title, plot::Svg& svg) {
  draw(scale, Rectangle{{FigureMargin, TreePlace.corner.y + 20}, 12, TreePlace.height - 40}, svg);
  double y = TreePlace.corner.y + 12 - 14 * static_cast<double>(title.size() - 1);
  for (const std::string& line : title) {
    svg.text({FigureMargin, y}, line, Small);
    y += 14;
  }
}

void draw_values(const SubdivisionSubject& subject, plot::Svg& svg) {
  const DiscMap map([&](const Vec3f& v) {
    return reflectance::mean(reflectance::evaluate(subject.viewed.brdf, subject.viewed.u, v));
  });
  const plot::ColourScale scale(map.least(), map.largest());
  draw(map, scale, TreePlace, svg);
  draw_bar(scale, {"f, 1/sr"}, svg);
}

void draw_masses(const Subdivision& tree, plot::Svg& svg) {
  const auto [least, largest] = std::ranges::minmax(tree.cells(), {}, &Cell::mass);
  const plot::ColourScale scale(least.mass, largest.mass);
  fill_cells(
      tree, scale, [&](std::size_t i) { return std::optional(tree.cells()[i].mass); }, svg);
  draw_bar(scale, {"mass"}, svg);
}

void draw_acceptances(const Subdivision& tree, plot::Svg& svg) {
  const plot::LinearColourScale scale(0, 1, plot::LinearColourScale::Palette::Sequential);
  fill_cells(
      tree, scale, [&](std::size_t i) { return std::optional(tree.cells()[i].acceptance); }, svg);
  draw_bar(scale, {"acceptance"}, svg);
}

void draw_deviations(const SubdivisionSubject& subject, plot::Svg& svg) {
  const plot::LinearColourScale scale(-MostDeviation, MostDeviation,
                                      plot::LinearColourScale::Palette::Diverging);
  fill_cells(
      subject.tree, scale,
      [&](std::size_t i) {
        return subject.samples.expected[i] >= FewestExpected ? std::optional(deviation(subject.samples, i))
                                                             : std::nullopt;
      },
      svg);
  draw_bar(scale, {"(n \u2212 e) / \u221Ae"}, svg);
}

void draw_outlines(const Subdivision& tree, plot::Svg& svg) {
  svg.begin_clip(centre(), TreePlace.width / 2);
  for (const Cell& cell : tree.cells()) {
    const auto corners = outline_of(tree, cell.range);
    svg.polyline(std::array{corners[0], corners[1], corners[2], corners[3], corners[0]}, {"#777", 0.6});
  }
  svg.end_clip();
  svg.circle(centre(), TreePlace.width / 2, {"#888", 1});
}

/// Returns the colour of samples on the disc, which a red cell does not hide.
std::string_view dot_colour(const SubdivisionSubject& subject) {
  return subject.settings.coloured_by == SubdivisionSettings::ChiSquare ? "#5b4a3f" : SampleColour;
}

const SampledPoint* shown_sample(const SubdivisionSubject& subject) {
  const auto number = static_cast<std::size_t>(std::lround(subject.settings.sample));
  if (number == 0 || number > subject.samples.points.size()) return nullptr;
  return &subject.samples.points[number - 1];
}

/// Returns a point of a node near its upper right corner that is inside the disc.
Point label_end(const std::array<Point, 4>& corners) {
  constexpr double Radius = TreePlace.width / 2;
  const Point corner = *std::ranges::max_element(corners, {}, [](const Point& p) { return p.x - p.y; });
  const Point middle = (corners[0] + corners[2]) / 2;
  constexpr int Parts = 20;
  for (int part = Parts; part > 0; --part) {
    const Point point = middle + (corner - middle) * part / Parts;
    if ((point - centre()).length() < Radius) return point;
  }
  return centre() + (middle - centre()).normalized() * Radius;
}

/// Draws the nodes on a sample's way, with the probability of each choice at the right.
void draw_way(const SubdivisionSubject& subject, plot::Svg& svg) {
  constexpr double LabelAt = TreePlace.corner.x + TreePlace.width + 16;
  const SampledPoint* sample = shown_sample(subject);
  if (sample == nullptr) return;
  std::vector<Subdivision::Step> steps = subject.tree.path_to(sample->direction.x, sample->direction.y);
  const auto shown = static_cast<std::size_t>(std::lround(subject.settings.step)) + 1;
  const bool is_whole = shown >= steps.size();
  if (!is_whole) steps.resize(shown);
  std::vector<double> wishes;
  std::vector<Point> ends;
  double mass = 1;
  svg.begin_clip(centre(), TreePlace.width / 2 + 1);
  for (const Subdivision::Step& step : steps) {
    const auto corners = outline_of(subject.tree, step.range);
    const std::array loop = {corners[0], corners[1], corners[2], corners[3], corners[0]};
    svg.polyline(loop, {"#fff", 3.2});
    svg.polyline(loop, {WayColour, 1.6});
    ends.push_back(label_end(corners));
    wishes.push_back(ends.back().y);
    mass *= step.probability;
  }
  svg.end_clip();
  svg.circle(centre(), TreePlace.width / 2, {WayColour, 1.6});
  const std::vector<double> heights =
      plot::spread_labels(wishes, 26, TreePlace.corner.y + 8, TreePlace.corner.y + TreePlace.height - 60);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    svg.line(ends[i], {LabelAt - 4, heights[i] - 4}, {WayColour, 0.6});
    svg.text({LabelAt, heights[i]}, fmt::format("{}: {:.3g} %", i, 100 * steps[i].probability),
             {11, WayColour, Anchor::Start, 0});
  }
  const Point dot = on_disc(sample->direction.x, sample->direction.y);
  svg.dots(std::array{dot}, 3.4, "#fff");
  svg.dots(std::array{dot}, 2.4, WayColour);
  const double bottom = TreePlace.corner.y + TreePlace.height;
  svg.text({LabelAt, bottom - 22}, is_whole ? "mass of" : "mass at", {11, WayColour, Anchor::Start, 0});
  svg.text({LabelAt, bottom - 8}, is_whole ? "the cell" : fmt::format("level {}", steps.size() - 1),
           {11, WayColour, Anchor::Start, 0});
  svg.text({LabelAt, bottom + 6}, fmt::format("{:.3g} %", 100 * mass), {11, WayColour, Anchor::Start, 0});
}

std::string count_text(const SubdivisionSubject& subject) {
  const CellSamples& samples = subject.samples;
  std::string text = subject.is_file()
                         ? fmt::format("{} directions of {}", samples.points.size(), subject.file)
                         : fmt::format("{} of {} samples", samples.points.size(), samples.count());
  const auto add = [&](std::size_t count, std::string_view what) {
    if (count == 0) return;
    text += fmt::format(", {} {}", count, what);
    if (samples.count() > 0)
      text +=
          fmt::format(" ({:.3g} %)", 100 * static_cast<double>(count) / static_cast<double>(samples.count()));
  };
  add(samples.rejected, subject.is_file() ? "not above the surface" : "rejected");
  add(samples.specular, "specular");
  return text;
}

void draw_legend(const SubdivisionSubject& subject, plot::Svg& svg) {
  const double y = TreePlace.corner.y + TreePlace.height + 26;
  svg.dots(std::array{Point(FigureMargin + 4, y - 4)}, 3, dot_colour(subject));
  svg.text({FigureMargin + 14, y}, count_text(subject), Small);
  const Point ring(TreePlace.corner.x + TreePlace.width - 38, y - 4);
  svg.circle(ring, 4, {"#111", 1.2});
  svg.text(ring + Point(10, 4), "view", Small);
  if (!subject.is_file())
    svg.text({FigureMargin + 14, y + 17}, "sampled by " + grf::to_text(subject.pdf), Small);
  const GoodnessOfFit& fit = subject.samples.fit;
  svg.text({FigureMargin + 14, y + (subject.is_file() ? 17 : 34)},
           fmt::format("chi-square {:.4g} of {} degrees of freedom: p = {:.3g}{}", fit.statistic, fit.degrees,
                       fit.p_value, subject.is_file() ? ", if they follow f cos" : ""),
           Small);
  if (subject.settings.coloured_by == SubdivisionSettings::ChiSquare)
    svg.text({FigureMargin + 14, y + (subject.is_file() ? 34 : 51)},
             fmt::format("n counted and e expected per cell; grey: e below {}, pooled", FewestExpected),
             {11, "#666", Anchor::Start, 0});
}

void draw_tree(const SubdivisionSubject& subject, plot::Svg& svg) {
  svg.text(TreePlace.corner + Point(0, -14), "Cells on the unit disc", Title);
  switch (subject.settings.coloured_by) {
    case SubdivisionSettings::Mass:
      draw_masses(subject.tree, svg);
      break;
    case SubdivisionSettings::Acceptance:
      draw_acceptances(subject.tree, svg);
      break;
    case SubdivisionSettings::ChiSquare:
      draw_deviations(subject, svg);
      break;
    default:
      draw_values(subject, svg);
  }
  draw_outlines(subject.tree, svg);
  std::vector<Vec3f> directions;
  for (const SampledPoint& point : subject.samples.points) directions.push_back(point.direction);
  draw_directions(directions, TreePlace, dot_colour(subject), svg);
  mark_view(subject.viewed.u, TreePlace, svg);
  draw_way(subject, svg);
  draw_legend(subject, svg);
}

void draw_lobe_panel(const SubdivisionSubject& subject, const StudyContext& context, plot::Svg& svg) {
  SampleCloud cloud{{}, {}, SampleColour};
  for (const SampledPoint& point : subject.samples.points) {
    cloud.directions.push_back(point.direction);
    cloud.values.push_back(point.f);
  }
  const SampledLobe lobe(subject.viewed.brdf, subject.viewed.u, {plot::Channel::Mean, false, false}, {cloud},
                         context.is_stopped);
  const HemisphereView view(subject.settings.azimuth, subject.settings.elevation, LobePlace);
  lobe.draw(view, svg);
  if (const SampledPoint* sample = shown_sample(subject)) {
    const Point dot = view.point(lobe.position(sample->direction, sample->f));
    svg.dots(std::array{dot}, 4.4, "#fff");
    svg.dots(std::array{dot}, 3.2, WayColour);
  }
  svg.text(LobeTitleAt, "Lobe of f with the samples", Title);
  svg.text(LobeTitleAt + Point(0, 17), lobe.scale_text(), {11, "#666", Anchor::Start, 0});
}

}  // namespace

void draw_subdivision_header(const SubdivisionSubject& subject, const std::string& facts, plot::Svg& svg) {
  const std::string brdf = grf::to_text(subject.viewed.model);
  svg.text({FigureMargin, 30}, brdf,
           {plot::fitting_size(17, brdf, svg.width() - 2 * FigureMargin), "#111", Anchor::Start, 0});
  svg.text({FigureMargin, 54}, viewed_text(subject.viewed.view) + "; " + facts,
           {13, "#333", Anchor::Start, 0});
}

void draw_subdivision(const SubdivisionSubject& subject, const StudyContext& context, plot::Svg& svg) {
  const Subdivision& tree = subject.tree;
  draw_subdivision_header(subject,
                          fmt::format("{} cells to depth {}; {:.3g} tries per sample", tree.cells().size(),
                                      tree.deepest(), tree.mean_tries()),
                          svg);
  draw_tree(subject, svg);
  draw_lobe_panel(subject, context, svg);
  draw_strata(subject, StrataPlace, svg);
}

std::string described_cell(const SubdivisionSubject& subject, const Point& at) {
  const double x = 2 * (at.x - TreePlace.corner.x) / TreePlace.width - 1;
  const double y = 1 - 2 * (at.y - TreePlace.corner.y) / TreePlace.height;
  const auto index = subject.tree.cell_at(x, y);
  if (!index) return {};
  const Cell& cell = subject.tree.cells()[*index];
  const reflectance::Box box = reflectance::DiscGrid::box(cell.range, subject.tree.grid().resolution());
  return fmt::format(
      "Cell at depth {}, x {:.3g} to {:.3g}, y {:.3g} to {:.3g}: mass {:.3g} %, bound {:.4g} 1/sr, "
      "acceptance {:.3g} %; {} samples, {:.4g} expected",
      cell.depth, box.x0, box.x1, box.y0, box.y1, 100 * cell.mass, cell.maximum, 100 * cell.acceptance,
      subject.samples.counted[*index], subject.samples.expected[*index]);
}

}  // namespace studies
