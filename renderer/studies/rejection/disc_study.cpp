// The study of f cos of a BRDF.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "grf/write.h"
#include "renderer/reflectance/brdf_instance.h"
#include "renderer/studies/disc_plot.h"
#include "renderer/studies/fit_samples.h"
#include "renderer/studies/goodness_of_fit.h"
#include "renderer/studies/rejection/disc.h"
#include "renderer/studies/rejection/figure.h"
#include "renderer/studies/rejection/random.h"
#include "renderer/studies/rejection/settings.h"

namespace studies {
namespace {

using plot::Anchor;
using plot::Point;
using plot::Rectangle;
using reflectance::Vec3f;
namespace colours = rejection_colours;

constexpr Rectangle SinglePlace = {{40, 118}, 234, 234};
constexpr Rectangle TreePlace = {{320, 118}, 234, 234};
constexpr Rectangle SlicePlace = {{20, 376}, 550, 230};

/// Tries that are made in the plane of incidence, to show: few of those on the disc are near it.
constexpr int SliceTries = 700;

/// All that is computed for the figure.
struct DiscResult {
  reflectance::Brdf brdf;
  Angles view;
  DiscFunction function;
  std::vector<Peak> peaks;
  DiscCells cells;
  DiscTree tree;
  double bound = 0;
  double sampled_total = 0;                     ///< the integral of f up to the bound
  std::optional<DiscCells> sampled_cells = {};  ///< of f up to a bound that is too low
  Run<Point> run = {};
  Run<Point> tree_run = {};

  DiscResult(const reflectance::Brdf& of, const Angles& from, const RejectionToolSettings& settings)
      : brdf(of),
        view(from),
        function(brdf, view),
        peaks(find_peaks(function)),
        tree(function, settings.cell_count(), settings.nmax) {}
  DiscResult(const DiscResult&) = delete;
  DiscResult& operator=(const DiscResult&) = delete;

  double exact() const { return peaks.empty() ? 0 : peaks.front().value; }
  bool is_too_low() const { return bound < exact() * (1 - 1e-6); }
};

/// Computes what does not follow from the BRDF alone.
void complete(DiscResult& result, const RejectionToolSettings& settings, const StudyContext& context) {
  const DiscFunction& f = result.function;
  result.bound = settings.chosen_bound(result.exact(), result.tree.grid_maximum());
  result.cells = integrate([&](double x, double y) { return f(x, y); }, result.peaks);
  result.sampled_total = result.cells.total;
  if (result.is_too_low()) {
    result.sampled_cells =
        integrate([&](double x, double y) { return std::min(f(x, y), result.bound); }, result.peaks);
    result.sampled_total = result.sampled_cells->total;
  }
  const RunLimits limits = settings.limits(context);
  result.run = sample_disc(f, result.bound, settings.region_of_tries(), limits, settings.seed_number());
  result.tree_run = result.tree.sample(limits, settings.seed_number());
}

bool is_valid(const ToolState& state, const DiscResult& result, const RejectionToolSettings& settings,
              grf::Diagnostics& diagnostics) {
  const grf::BrdfModel& model = state.brdfs.front();
  if (!reflectance::has_nonspecular_part(result.brdf) && reflectance::has_specular_part(result.brdf)) {
    diagnostics.error(model.location,
                      fmt::format("the BRDF '{}' is only a mirror (delta part), whose density is infinite: "
                                  "no bound is above it",
                                  model.keyword));
    return false;
  }
  if (!(result.exact() > 0)) {
    diagnostics.error(model.location,
                      fmt::format("f of '{}' is 0 in all directions for this view: there is nothing to "
                                  "sample",
                                  model.keyword));
    return false;
  }
  if (settings.bound == RejectionToolSettings::Grid && !(result.tree.grid_maximum() > 0)) {
    diagnostics.error(
        state.settings.location,
        fmt::format("f is 0 at the centres of all {0} x {0} cells: use more 'cells'", settings.cell_count()));
    return false;
  }
  return true;
}

void draw_disc(const std::vector<Try<Point>>& tries, const Rectangle& place, const Vec3f& u, plot::Svg& svg) {
  std::vector<Vec3f> accepted;
  std::vector<Vec3f> rejected;
  for (const Try<Point>& one : tries) {
    const Vec3f at(static_cast<float>(one.place.x), static_cast<float>(one.place.y), 0);
    (one.is_accepted ? accepted : rejected).push_back(at);
  }
  draw_directions(rejected, place, colours::Rejected, svg);
  draw_directions(accepted, place, colours::Accepted, svg);
  const Point centre = place.corner + Point(place.width, place.height) / 2;
  svg.circle(centre, place.width / 2, {"#888", 1});
  mark_view(u, place, svg);
}

/// Returns whether the box of a leaf is large enough to be told apart.
bool is_drawn(const reflectance::Box& box) {
  constexpr double LeastSide = 2;  // in pixels
  return (box.x1 - box.x0) / 2 * TreePlace.width >= LeastSide;
}

void draw_leaves(const DiscTree& tree, const Rectangle& place, plot::Svg& svg) {
  const Point centre = place.corner + Point(place.width, place.height) / 2;
  svg.begin_clip(centre, place.width / 2);
  tree.visit_leaves([&](const reflectance::Box& box) {
    const auto at = [&](double x, double y) { return point_on_disc(x, y, place); };
    if (!is_drawn(box)) return;
    svg.polyline(std::array{at(box.x1, box.y0), at(box.x0, box.y0), at(box.x0, box.y1)},
                 {colours::Tree, 0.6});
  });
  svg.end_clip();
}

std::string tries_title(std::string_view what, const Run<Point>& run) {
  return run.tries > RunLimits::MostRecorded
             ? fmt::format("{}: the first {} tries", what, RunLimits::MostRecorded)
             : fmt::format("{}: {} tries", what, run.tries);
}

void draw_discs(const DiscResult& result, Region region, plot::Svg& svg) {
  svg.text({SinglePlace.corner.x - 20, 106}, tries_title("One bound", result.run),
           {13, "#111", Anchor::Start, 0});
  svg.text({TreePlace.corner.x - 20, 106}, tries_title("Quadtree", result.tree_run),
           {13, "#111", Anchor::Start, 0});
  const Vec3f u = result.function.plane_u();
  if (region == Region::Square) {
    const Point& corner = SinglePlace.corner;
    const double side = SinglePlace.width;
    svg.polyline(std::array{corner, corner + Point(side, 0), corner + Point(side, side),
                            corner + Point(0, side), corner},
                 {"#bbb", 1});
  }
  draw_disc(result.run.recorded, SinglePlace, u, svg);
  draw_leaves(result.tree, TreePlace, svg);
  draw_disc(result.tree_run.recorded, TreePlace, u, svg);
}

/// Returns places for a line, dense around the largest maximum.
std::vector<double> slice_places(const DiscResult& result) {
  constexpr int Even = 360;
  constexpr int Dense = 50;
  std::vector<double> places;
  for (int i = 0; i <= Even; ++i) places.push_back(std::sin(LimitDegrees * Degree * (2.0 * i / Even - 1)));
  const double peak = result.peaks.front().at.x;
  for (int k = 0; k < Dense; ++k) {
    const double away = std::pow(10, -k / 10.0);
    for (const double x : {peak - away, peak + away}) {
      if (std::abs(x) < places.back()) places.push_back(x);
    }
  }
  std::ranges::sort(places);
  return places;
}

plot::Series slice_of_tree(const DiscResult& result, int cells) {
  plot::Series steps = {"", {}, colours::Tree};
  for (int i = 0; i < cells; ++i) {
    const double middle = (i + 0.5) / cells * 2 - 1;
    const double bound = result.tree.bound_at({middle, 0});
    steps.points.emplace_back(2.0 * i / cells - 1, bound);
    steps.points.emplace_back(2.0 * (i + 1) / cells - 1, bound);
  }
  return steps;
}

plot::Chart slice_chart(const DiscResult& result, int cells, std::uint32_t seed) {
  plot::Chart chart;
  chart.title = "Slice in the plane of incidence, with tries in it";
  chart.x = {"x, the sine of the angle from the normal; the view is at the right", false, -1, 1};
  chart.y = {"f, 1/sr", false, 0, 1.06 * std::max(result.bound, result.exact())};
  plot::Series curve = {"", {}, colours::Function};
  for (const double x : slice_places(result)) curve.points.emplace_back(x, result.function(x, 0));
  if (result.is_too_low()) chart.series.push_back(lost_above(curve.points, result.bound));
  std::vector<Point> accepted;
  std::vector<Point> rejected;
  reflectance::SplitMix random = random_numbers(seed);
  for (int i = 0; i < SliceTries; ++i) {
    const double x = 2 * random.next() - 1;
    const double height = random.next() * result.bound;
    (height < result.function(x, 0) ? accepted : rejected).emplace_back(x, height);
  }
  chart.series.push_back(dots_of(std::move(rejected), colours::Rejected));
  chart.series.push_back(dots_of(std::move(accepted), colours::Accepted));
  chart.series.push_back(slice_of_tree(result, cells));
  chart.series.push_back({"", {{-1, result.bound}, {1, result.bound}}, colours::Bound});
  chart.series.push_back(std::move(curve));
  return chart;
}

/// Returns the probability of each column of cells as steps of a density of x.
std::vector<Point> column_densities(const DiscCells& cells) {
  std::vector<Point> steps;
  constexpr double Width = 2.0 / DiscCells::Columns;
  for (int i = 0; i < DiscCells::Columns; ++i) {
    double mass = 0;
    for (int k = 0; k < DiscCells::Rows; ++k)
      mass += cells.masses[static_cast<std::size_t>(i) * static_cast<std::size_t>(DiscCells::Rows) +
                           static_cast<std::size_t>(k)];
    steps.emplace_back(Width * i - 1, mass / (cells.total * Width));
    steps.emplace_back(Width * (i + 1) - 1, mass / (cells.total * Width));
  }
  return steps;
}

std::vector<double> counts_of(const std::vector<Point>& points) {
  std::vector<double> counts(std::size_t{DiscCells::Columns} * DiscCells::Rows);
  for (const Point& point : points) counts[DiscCells::cell_of(point)] += 1;
  return counts;
}

/// Tests points on the cells of the disc, of which pairs of columns are joined: a test with fewer classes
/// notices smaller deviations.
std::optional<double> p_value_of(const DiscCells& cells, const std::vector<Point>& points) {
  constexpr std::size_t Rows = DiscCells::Rows;
  const std::vector<double> all = counts_of(points);
  std::vector<double> expected(cells.masses.size() / 2);
  std::vector<double> counts(expected.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t joined = i / (2 * Rows) * Rows + i % Rows;
    expected[joined] += cells.masses[i] / cells.total * static_cast<double>(points.size());
    counts[joined] += all[i];
  }
  const GoodnessOfFit fit = goodness_of_fit(expected, counts);
  return fit.degrees > 0 ? std::optional(fit.p_value) : std::nullopt;
}

Histogram histogram_of(const DiscResult& result) {
  const std::vector<double> counts = counts_of(result.run.accepted);
  Histogram histogram = {"x, along the plane of incidence", "density of x", -1, 1, {}, {}, {}};
  const auto count = static_cast<double>(std::max<std::size_t>(1, result.run.accepted.size()));
  for (std::size_t i = 0; i < DiscCells::Columns; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < DiscCells::Rows; ++k) sum += counts[i * DiscCells::Rows + k];
    histogram.densities.push_back(sum / count * DiscCells::Columns / 2);
  }
  histogram.expected = column_densities(result.cells);
  if (result.sampled_cells) histogram.sampled = column_densities(*result.sampled_cells);
  return histogram;
}

RejectionReport report_of(const ToolState& state, const RejectionToolSettings& settings,
                          const DiscResult& result) {
  RejectionReport report;
  const Region region = settings.region_of_tries();
  report.title = grf::to_text(state.brdfs.front());
  report.note =
      fmt::format("{}; f over the disc of (x, y) is f cos over directions; tries are uniform on the {}",
                  viewed_text(result.view), region == Region::Disc ? "disc" : "square around it");
  report.subdivision = "quadtree";
  report.single = numbers_of(result.run, result.sampled_total / (result.bound * area_of(region)),
                             fmt::format("{:.4g} 1/sr", result.bound));
  report.single.p_value = p_value_of(result.cells, result.run.accepted);
  const std::size_t leaves = result.tree.leaves();
  report.tree = numbers_of(result.tree_run, result.tree.acceptance(),
                           fmt::format("{} {}", leaves, leaves == 1 ? "leaf" : "leaves"));
  report.tree->p_value = p_value_of(result.cells, result.tree_run.accepted);
  report.remarks.push_back(compared_maxima(result.exact(), result.tree.grid_maximum(),
                                           fmt::format("over {0} x {0} cells", settings.cell_count())));
  const Peak& peak = result.peaks.front();
  if (peak.at.length() > std::sin(89.8 * Degree))
    report.remarks.push_back(
        fmt::format("The maximum is at the horizon: directions beyond {}\u00B0 are left out.", LimitDegrees));
  bool are_drawn = true;
  result.tree.visit_leaves([&](const reflectance::Box& box) { are_drawn = are_drawn && is_drawn(box); });
  if (!are_drawn) report.remarks.emplace_back("Leaves smaller than 2 pixels are not drawn.");
  if (reflectance::has_specular_part(result.brdf))
    report.remarks.emplace_back("The mirror (delta) part is left out.");
  add_warnings(result.run, settings.limits({}).samples, report.warnings);
  report.histogram = histogram_of(result);
  return report;
}

std::string csv_of(const DiscResult& result) {
  std::string text = "x,y,z,f\n";
  for (const Point& point : result.run.accepted) {
    const Vec3f v = result.function.direction(point);
    text += fmt::format("{},{},{},{}\n", v.x, v.y, v.z, result.function(point.x, point.y));
  }
  return text;
}

std::string fit_text(const ToolState& state, const DiscResult& result) {
  grf::BrdfModel model = state.brdfs.front();
  if (!model.terms.empty()) return {};  // a FIT file has no definitions
  // Nobody knows yet where the FIT file will be.
  if (!model.data_file.empty()) {
    const std::string beside =
        model.location.file ? grf::path_beside(model.location.file->path, model.data_file) : model.data_file;
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::absolute(beside, error);
    if (!error) model.data_file = absolute.lexically_normal().generic_string();
  }
  std::vector<reflectance::ScatterSample> samples;
  for (const Point& point : result.run.accepted)
    samples.push_back({result.function.direction(point), {}, 0, false});
  const reflectance::Reflector reflector(result.brdf, reflectance::OwnScheme());
  return plot::to_text(fit_of(model, reflector, result.view, samples, {}));
}

/// Describes a point of the disc, or of the slice.
std::string described(const DiscResult& result, const Rectangle& slice, const Point& at) {
  Point point;
  bool is_on_disc = false;
  for (const Rectangle& place : {SinglePlace, TreePlace}) {
    const Point from = at - place.corner;
    const Point here(2 * from.x / place.width - 1, 1 - 2 * from.y / place.height);
    if (here.length() >= 1) continue;
    point = here;
    is_on_disc = true;
  }
  if (!is_on_disc) {
    const Point from = at - slice.corner;
    if (from.x <= 0 || from.x >= slice.width || from.y < 0 || from.y > slice.height) return {};
    point = {2 * from.x / slice.width - 1, 0};
  }
  const Vec3f v = result.function.direction(point);
  const double f = result.function(point.x, point.y);
  return fmt::format(
      "\u03B8 = {:.3g}\u00B0, \u03C6 = {:.3g}\u00B0: f = {:.4g} 1/sr, accepted {:.3g} % under the bound "
      "{:.4g}; the leaf's bound is {:.4g}",
      std::asin(std::min(point.length(), 1.0)) / Degree, std::atan2(v.y, v.x) / Degree, f,
      100 * std::min(1.0, f / result.bound), result.bound, result.tree.bound_at(point));
}

}  // namespace

std::optional<Study> disc_study(const ToolState& state, const RejectionToolSettings& settings,
                                const StudyContext& context, grf::Diagnostics& diagnostics) {
  const auto brdf = reflectance::make_brdf(state.brdfs.front(), diagnostics, state.definitions);
  if (!brdf) return std::nullopt;
  const auto view = reflectance::make<BrdfView>(*state.distribution);
  const auto result =
      std::make_shared<DiscResult>(*brdf, Angles{view.theta * Degree, view.phi * Degree}, settings);
  if (!is_valid(state, *result, settings, diagnostics)) return std::nullopt;
  complete(*result, settings, context);
  const RejectionReport report = report_of(state, settings, *result);
  std::vector<LegendItem> legend = {{colours::Accepted, "accepted"},
                                    {colours::Rejected, "rejected"},
                                    {colours::Function, "f", true},
                                    {colours::Bound, "bound", true},
                                    {colours::Tree, "bounds and leaves of the quadtree", true}};
  if (result->is_too_low()) legend.push_back({colours::Lost, "above the bound: lost"});
  const plot::Chart slice = slice_chart(*result, settings.cell_count(), settings.seed_number());
  plot::Svg svg(RejectionWidth, RejectionHeight, context.paper);
  draw_discs(*result, settings.region_of_tries(), svg);
  draw(slice, SlicePlace, svg);
  draw_report(report, legend, svg);
  Study study{std::move(svg), summary_of(report, result->run.tries, result->run.accepted.size()),
              csv_of(*result), fit_text(state, *result)};
  study.describe = [result, area = plot_area(slice, SlicePlace)](const Point& at) {
    return described(*result, area, at);
  };
  return study;
}

}  // namespace studies
