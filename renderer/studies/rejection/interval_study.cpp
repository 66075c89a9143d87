// The study of a statistical distribution.
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "renderer/studies/goodness_of_fit.h"
#include "renderer/studies/rejection/figure.h"
#include "renderer/studies/rejection/interval.h"
#include "renderer/studies/rejection/settings.h"

namespace studies {
namespace {

using plot::Point;
namespace colours = rejection_colours;

constexpr plot::Rectangle TriesPlace = {{20, 92}, 540, 514};

/// All that is computed for the figure.
struct IntervalResult {
  Density density;
  double bound = 0;
  double exact = 0;
  double grid = 0;
  double sampled_mass = 0;  ///< the density's integral up to the bound
  Run<double> run;
  std::optional<IntervalTree> tree;
  std::optional<Run<double>> tree_run;
  double top = 0;  ///< of the chart of tries

  bool is_too_low() const { return bound < exact * (1 - 1e-9); }
};

/// Returns the distribution's title with the values of its parameters.
std::string title_of(const grf::Model& model) {
  const std::vector<grf::ModelInfo> infos = density_infos();
  const grf::ModelInfo* info = grf::find_model(infos, model.keyword);
  std::string text(info->title);
  char separator = ':';
  for (const grf::ParameterInfo& parameter : info->parameters) {
    const grf::Argument* argument = grf::find_argument(model, parameter);
    const auto* number = argument != nullptr ? std::get_if<float>(&argument->value) : nullptr;
    text += fmt::format("{} {} = {:.4g}", separator, parameter.name,
                        number != nullptr ? *number : parameter.default_value);
    separator = ',';
  }
  return text;
}

std::string note_of(const Density& density, const RejectionToolSettings& settings) {
  const std::string interval = fmt::format("[{:.6g}, {:.6g}]", density.low, density.high);
  if (!density.is_cut_low && !density.is_cut_high) return "Tries are uniform on the support, " + interval;
  return fmt::format("Tries are uniform on {}: the support is cut at the {}quantile{} of {:.3g} %{}",
                     interval, density.is_cut_low ? "" : "upper ", density.is_cut_low ? "s" : "",
                     settings.tail,
                     density.is_cut_low ? fmt::format(" and {:.6g} %", 100 - settings.tail) : "");
}

/// Reports a density that no bound is above.
bool check_pole(const grf::Model& model, const Density& density, const RejectionToolSettings& settings,
                grf::Diagnostics& diagnostics) {
  if (!density.has_pole() || settings.bound == RejectionToolSettings::Grid) return true;
  grf::SourceLocation location = model.location;
  for (const grf::Argument& argument : model.arguments) {
    if (grf::same_keyword(argument.name, density.pole_parameter)) location = argument.location;
  }
  const int least = grf::same_keyword(density.pole_parameter, "freedom") ? 2 : 1;
  diagnostics.error(
      location,
      fmt::format("the density of '{}' is infinite at x = {} as '{}' is below {}, so that no bound is above "
                  "it: use at least {}, or bound=grid, which shows what a bound that is too low does",
                  model.keyword, density.pole, density.pole_parameter, least, least));
  return false;
}

IntervalResult result_of(const Density& density, const RejectionToolSettings& settings,
                         const StudyContext& context) {
  IntervalResult result;
  result.density = density;
  result.exact = density.maximum();
  result.grid = grid_maximum(density, settings.cell_count());
  result.bound = settings.chosen_bound(result.exact, result.grid);
  const double mass = density.mass();
  result.sampled_mass = result.is_too_low() ? mass_below(density, result.bound) : mass;
  const RunLimits limits = settings.limits(context);
  result.run = sample_interval(density, result.bound, limits, settings.seed_number());
  if (!density.has_pole()) {
    result.tree.emplace(density, settings.nmax);
    result.tree_run = sample_interval(density, *result.tree, limits, settings.seed_number());
  }
  result.top = 1.06 * (density.has_pole() ? 1.5 * result.bound : std::max(result.bound, result.exact));
  return result;
}

/// Returns places for a line: evenly over the interval, and dense around the mode and at the ends, as a peak
/// may be much narrower than the interval.
std::vector<double> places_of(const Density& density) {
  constexpr int Even = 400;
  constexpr int Dense = 60;
  std::vector<double> places;
  for (int i = 0; i <= Even; ++i) places.push_back(density.low + density.width() * i / Even);
  for (int k = 0; k < Dense; ++k) {
    const double away = density.width() * std::pow(10, -k / 10.0);
    for (const double x :
         {density.mode - away, density.mode + away, density.low + away, density.high - away}) {
      if (x > density.low && x < density.high) places.push_back(x);
    }
  }
  places.push_back(density.mode);
  std::ranges::sort(places);
  return places;
}

plot::Chart chart_of(const IntervalResult& result) {
  const Density& density = result.density;
  plot::Chart chart;
  chart.title =
      fmt::format("Tries under the bound{}",
                  result.run.tries > result.run.recorded.size()
                      ? fmt::format(": the first {} of {}", result.run.recorded.size(), result.run.tries)
                      : fmt::format(": {}", result.run.tries));
  chart.x = {"x", false, density.low, density.high};
  chart.y = {"density", false, 0, result.top};
  plot::Series curve = {"", {}, colours::Function};
  for (const double x : places_of(density)) curve.points.emplace_back(x, density.pdf(x));
  if (result.is_too_low()) chart.series.push_back(lost_above(curve.points, result.bound));
  std::vector<Point> accepted;
  std::vector<Point> rejected;
  for (const Try<double>& one : result.run.recorded)
    (one.is_accepted ? accepted : rejected).emplace_back(one.place, one.height);
  chart.series.push_back(dots_of(std::move(rejected), colours::Rejected));
  chart.series.push_back(dots_of(std::move(accepted), colours::Accepted));
  if (result.tree) {
    plot::Series steps = {"", {}, colours::Tree};
    for (const IntervalTree::Leaf& leaf : result.tree->leaves()) {
      steps.points.emplace_back(leaf.low, leaf.bound);
      steps.points.emplace_back(leaf.high, leaf.bound);
    }
    chart.series.push_back(std::move(steps));
  }
  chart.series.push_back({"", {{density.low, result.bound}, {density.high, result.bound}}, colours::Bound});
  chart.series.push_back(std::move(curve));
  return chart;
}

Histogram histogram_of(const IntervalResult& result) {
  constexpr std::size_t Bins = 40;
  const Density& density = result.density;
  Histogram histogram = {"x", "density", density.low, density.high, std::vector<double>(Bins), {}, {}};
  const auto count = static_cast<double>(std::max<std::size_t>(1, result.run.accepted.size()));
  const double width = density.width() / Bins;
  for (const double x : result.run.accepted) {
    const auto bin = static_cast<std::size_t>((x - density.low) / width);
    histogram.densities[std::min(bin, Bins - 1)] += 1 / (count * width);
  }
  for (const double x : places_of(density)) {
    histogram.expected.emplace_back(x, density.pdf(x) / density.mass());
    if (!result.is_too_low()) continue;
    histogram.sampled.emplace_back(x, std::min(density.pdf(x), result.bound) / result.sampled_mass);
  }
  return histogram;
}

/// Tests the samples in classes of equal probability.
std::optional<double> p_value_of(const Density& density, const std::vector<double>& samples) {
  constexpr std::size_t MostClasses = 40;
  constexpr std::size_t SamplesPerClass = 10;
  const std::size_t classes = std::min(MostClasses, samples.size() / SamplesPerClass);
  if (classes < 2) return std::nullopt;
  std::vector<double> counts(classes);
  const double mass = density.mass();
  for (const double x : samples) {
    const double below = density.mass(density.low, x) / mass;
    counts[std::min(static_cast<std::size_t>(below * static_cast<double>(classes)), classes - 1)] += 1;
  }
  const double expected = static_cast<double>(samples.size()) / static_cast<double>(classes);
  return goodness_of_fit(std::vector<double>(classes, expected), counts).p_value;
}

RejectionReport report_of(const ToolState& state, const RejectionToolSettings& settings,
                          const IntervalResult& result) {
  RejectionReport report;
  report.title = title_of(*state.distribution);
  report.note = note_of(result.density, settings);
  report.subdivision = "subdivision";
  report.single = numbers_of(result.run, result.sampled_mass / (result.bound * result.density.width()),
                             fmt::format("{:.4g}", result.bound));
  report.single.p_value = p_value_of(result.density, result.run.accepted);
  if (result.tree) {
    const std::size_t parts = result.tree->leaves().size();
    report.tree = numbers_of(*result.tree_run, result.tree->acceptance(),
                             fmt::format("{} part{}", parts, parts == 1 ? "" : "s"));
    report.tree->p_value = p_value_of(result.density, result.tree_run->accepted);
  } else {
    report.no_tree_reason =
        fmt::format("No subdivision: the density is infinite at x = {}.", result.density.pole);
  }
  const std::string grid = fmt::format("over {} cells", settings.cell_count());
  report.remarks.push_back(compared_maxima(result.exact, result.grid, grid));
  add_warnings(result.run, settings.limits({}).samples, report.warnings);
  report.histogram = histogram_of(result);
  return report;
}

std::string csv_of(const IntervalResult& result) {
  std::string text = "x,density\n";
  for (const double x : result.run.accepted) text += fmt::format("{},{}\n", x, result.density.pdf(x));
  return text;
}

std::string described(const IntervalResult& result, const plot::Rectangle& area, const Point& at) {
  const Point part((at.x - area.corner.x) / area.width, (area.corner.y + area.height - at.y) / area.height);
  if (!(part.x >= 0 && part.x <= 1 && part.y >= 0 && part.y <= 1)) return {};
  const Density& density = result.density;
  const double x = density.low + part.x * density.width();
  const double value = density.pdf(x);
  std::string text = fmt::format("x = {:.4g}: density {:.4g}, accepted {:.3g} % under the bound {:.4g}", x,
                                 value, 100 * std::min(1.0, value / result.bound), result.bound);
  if (result.tree) {
    const double bound = result.tree->leaf_at(x).bound;
    text += fmt::format(", {:.3g} % under that of the part, {:.4g}", 100 * value / bound, bound);
  }
  return text;
}

}  // namespace

std::optional<Study> interval_study(const ToolState& state, const RejectionToolSettings& settings,
                                    const StudyContext& context, grf::Diagnostics& diagnostics) {
  const auto density = make_density(*state.distribution, settings.tail / 100);
  if (!density || !check_pole(*state.distribution, *density, settings, diagnostics)) return std::nullopt;
  const auto result = std::make_shared<const IntervalResult>(result_of(*density, settings, context));
  const RejectionReport report = report_of(state, settings, *result);
  std::vector<LegendItem> legend = {{colours::Accepted, "accepted"},
                                    {colours::Rejected, "rejected"},
                                    {colours::Function, "density", true},
                                    {colours::Bound, "bound", true}};
  if (result->tree) legend.push_back({colours::Tree, "bounds of the subdivision", true});
  if (result->is_too_low()) legend.push_back({colours::Lost, "above the bound: lost"});
  const plot::Chart chart = chart_of(*result);
  plot::Svg svg(RejectionWidth, RejectionHeight, context.paper);
  draw(chart, TriesPlace, svg);
  draw_report(report, legend, svg);
  Study study{std::move(svg),
              summary_of(report, result->run.tries, result->run.accepted.size()),
              csv_of(*result),
              {}};
  study.describe = [result, area = plot_area(chart, TriesPlace)](const Point& at) {
    return described(*result, area, at);
  };
  return study;
}

}  // namespace studies
