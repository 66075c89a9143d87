#include "renderer/fit/fit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grf/scene.h"
#include "grf/write.h"
#include "renderer/fit/problem.h"
#include "renderer/fit/solver.h"
#include "renderer/fit/uncertainty.h"
#include "renderer/parallel/loops.h"

namespace fit {
namespace {

// Each stage leaves fewer candidates to the next, which takes longer for each.
constexpr std::size_t ScannedObservations = 128;
constexpr std::size_t Starts = 48;
constexpr int StartIterations = 15;
constexpr std::size_t Survivors = 12;
constexpr std::size_t RefinedObservations = 400;
constexpr int SurvivorIterations = 40;
constexpr std::size_t Finalists = 2;
constexpr int FinalIterations = 150;

std::size_t scan_size(std::size_t shapes) {
  constexpr std::size_t Most = 4096;
  return std::min<std::size_t>(Most, std::size_t{64} << std::min<std::size_t>(shapes, 6));
}

/// Returns at most `count` of the observations, evenly from the list.
Observations thinned(const Observations& observations, std::size_t count) {
  const std::vector<Observation>& list = observations.list;
  if (list.size() <= count) return observations;
  Observations some;
  some.is_isotropic = observations.is_isotropic;
  some.is_grey = observations.is_grey;
  for (std::size_t i = 0; i < count; ++i) some.list.push_back(list[i * list.size() / count]);
  return some;
}

void keep_best(std::vector<Candidate>& candidates, std::size_t count) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  candidates.resize(std::min(candidates.size(), count));
}

/// Refines candidates from another problem of the same unknowns; drops those that are not taken here.
void refine_all(const Problem& problem, int iterations, std::vector<Candidate>& candidates) {
  std::vector<char> was_taken(candidates.size(), 0);
  parallel::for_each_index(candidates.size(), [&](std::size_t i) {
    const auto cost = problem.cost(candidates[i].x);
    if (!cost) return;
    candidates[i].cost = *cost;
    candidates[i] = refine(problem, candidates[i], iterations);
    was_taken[i] = 1;
  });
  std::vector<Candidate> taken;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (was_taken[i] != 0) taken.push_back(std::move(candidates[i]));
  }
  candidates = std::move(taken);
}

/// Finds the unknowns of the least cost; empty if the models take no values of the scan.
Candidate solve(const std::vector<Lobe>& lobes, const Observations& observations, const Problem& problem,
                Metric metric) {
  const Observations scanned = thinned(observations, ScannedObservations);
  const Problem smallest(lobes, scanned, metric);
  std::vector<Candidate> candidates = scan(smallest, scan_size(problem.shape_count()), Starts);
  refine_all(smallest, StartIterations, candidates);
  keep_best(candidates, Survivors);
  const Observations refined = thinned(observations, RefinedObservations);
  refine_all(Problem(lobes, refined, metric), SurvivorIterations, candidates);
  keep_best(candidates, Finalists);
  refine_all(problem, FinalIterations, candidates);
  keep_best(candidates, 1);
  return candidates.empty() ? Candidate() : candidates.front();
}

/// Returns the factor of a term of a sum: its own weight, or what brings its colours into their range.
double factor_of(const std::vector<Lobe>& lobes, std::size_t lobe, const Problem& problem,
                 std::span<const double> x) {
  if (lobes.size() == 1) return 1;
  if (lobes[lobe].has_weight) return problem.weight_of(lobe, x);
  double factor = 1;
  const std::vector<Vec3d> colours = problem.colours_of(lobe, x);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const Vec3d& colour = colours[i];
    factor = std::max(factor, std::max({colour.x, colour.y, colour.z}) / lobes[lobe].colours[i].maximum);
  }
  return factor;
}

std::vector<FitTerm> terms_of(const std::vector<Lobe>& lobes, const Problem& problem,
                              std::span<const double> x) {
  std::vector<FitTerm> terms;
  for (std::size_t i = 0; i < lobes.size(); ++i) {
    const double factor = factor_of(lobes, i, problem, x);
    std::vector<Vec3d> colours = problem.colours_of(i, x);
    if (!lobes[i].has_weight) {
      for (Vec3d& colour : colours) colour /= factor;
    }
    terms.push_back({factor, model_of(lobes[i], problem.shapes_of(i, x), colours)});
  }
  return terms;
}

reflectance::Brdf brdf_of_terms(const std::vector<FitTerm>& terms) {
  if (terms.size() == 1) return reflectance::make_brdf(terms[0].model).value();
  auto parts = std::make_shared<reflectance::CombinedBrdfs>();
  for (const FitTerm& term : terms) {
    parts->push_back({static_cast<float>(term.weight), reflectance::make_brdf(term.model).value(), nullptr});
  }
  return reflectance::Combine{parts};
}

FittedParameter parameter_of(const std::vector<Lobe>& lobes, const Problem& problem, std::size_t unknown,
                             double x, double factor, const Uncertainty& uncertainty) {
  const Problem::Name name = problem.name(unknown);
  const Lobe& lobe = lobes[name.lobe];
  FittedParameter parameter;
  parameter.term = name.lobe;
  parameter.channel = name.channel;
  parameter.is_determined = uncertainty.is_determined;
  parameter.is_at_bound = uncertainty.is_at_bound;
  const double low = std::max(0.0, x - uncertainty.half_width);
  const double high = std::min(problem.upper(unknown), x + uncertainty.half_width);
  if (name.shape) {
    const ShapeParameter& shape = lobe.shapes[*name.shape];
    parameter.name = shape.name;
    parameter.value = shape.value(x);
    parameter.low = shape.value(low);
    parameter.high = shape.value(high);
    parameter.is_determined &= uncertainty.half_width < 0.5;
    return parameter;
  }
  parameter.name = name.colour ? lobe.colours[*name.colour].name : "weight";
  const double divisor = name.colour ? factor : 1;
  parameter.value = x / divisor;
  parameter.low = low / divisor;
  parameter.high = high / divisor;
  parameter.is_determined &= uncertainty.half_width < 0.5 || uncertainty.half_width < 0.5 * x;
  return parameter;
}

void measure(const Observations& observations, Fit& fit) {
  std::vector<Vec3d> values;
  evaluate(fit.brdf, observations.list, values);
  const double mean = mean_of(observations.list);
  for (const Metric metric : Metrics) {
    const MetricScale scale(metric, mean);
    double squares = 0;
    double own_squares = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const Observation& one = observations.list[k];
      for (int c = 0; c < 3; ++c) {
        const double target = scale.value(one.value[c] * one.v.z);
        const double residual = scale.value(values[k][c] * one.v.z) - target;
        squares += one.weight * residual * residual;
        own_squares += one.weight * target * target;
      }
    }
    FitError& error = fit.errors[static_cast<std::size_t>(metric)];
    error.absolute = std::sqrt(squares / static_cast<double>(3 * values.size()));
    error.relative = std::sqrt(squares / own_squares);
  }
}

/// Returns the least cost of a diffuse BRDF, which any lobe should be better than.
double cost_of_diffuse(const Observations& observations, Metric metric) {
  grf::Diagnostics ignored;
  const auto lobes = lobes_of({"diffuse"}, {}, observations, ignored);
  if (!lobes) return 0;
  const Problem problem(*lobes, observations, metric);
  const std::vector<Candidate> start = scan(problem, 1, 1);
  return start.empty() ? 0 : refine(problem, start[0], FinalIterations).cost;
}

void add_warnings(const Observations& observations, const Problem& problem, const Candidate& best,
                  Metric metric, Fit& fit) {
  constexpr double LargeError = 0.1;
  const double error = std::sqrt(best.cost / problem.cost_of_black());
  if (error > LargeError) {
    const bool is_diffuse = fit.target.keywords == std::vector<std::string>{"diffuse"};
    const bool has_gained = best.cost < 0.7 * cost_of_diffuse(observations, metric);
    fit.warnings.push_back(fmt::format(
        "the residuals are {:.2g} % of the values in the metric '{}'{}", 100 * error, name_of(metric),
        is_diffuse || has_gained
            ? ": the model does not have the data's shape, or the data are noisy"
            : ", no better than those of a diffuse BRDF: the data are noise, or of no shape that "
              "the model has"));
  }
  std::vector<std::string> names;
  for (const FittedParameter& parameter : fit.parameters) {
    if (!parameter.is_determined && std::find(names.begin(), names.end(), parameter.name) == names.end())
      names.push_back(parameter.name);
  }
  if (!names.empty())
    fit.warnings.push_back(fmt::format("the data do not determine {}", fmt::join(names, ", ")));
}

}  // namespace

std::string Target::name() const {
  return keywords.size() == 1 ? keywords[0] : fmt::format("combine {}", fmt::join(keywords, " "));
}

std::optional<std::vector<Target>> targets_of(const std::string& text, std::size_t lobes) {
  std::vector<Target> targets;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    Target target;
    for (std::size_t at = begin; at < end;) {
      const std::size_t space = std::min(text.find(' ', at), end);
      if (space > at) target.keywords.push_back(text.substr(at, space - at));
      at = space + 1;
    }
    const bool is_sum = !target.keywords.empty() && target.keywords[0] == "combine";
    if (is_sum) target.keywords.erase(target.keywords.begin());
    if (target.keywords.empty() || (!is_sum && target.keywords.size() > 1)) return std::nullopt;
    if (!is_sum) target.keywords.resize(lobes, target.keywords[0]);
    targets.push_back(std::move(target));
    begin = end + 1;
  }
  return targets;
}

std::optional<Fit> fit_brdf(const Target& target, const Observations& observations,
                            const FitSettings& settings, grf::Diagnostics& diagnostics) {
  const auto start = std::chrono::steady_clock::now();
  const auto lobes = lobes_of(target.keywords, settings.fixed, observations, diagnostics);
  if (!lobes) return std::nullopt;
  const Problem problem(*lobes, observations, settings.metric);
  if (problem.residual_count() <= problem.unknown_count()) {
    diagnostics.error({}, fmt::format("'{}' has {} free parameters, and there are only {} values",
                                      target.name(), problem.unknown_count(), problem.residual_count()));
    return std::nullopt;
  }
  Candidate best;
  parallel::run_with_threads(settings.threads,
                             [&] { best = solve(*lobes, observations, problem, settings.metric); });
  if (best.x.empty()) {
    diagnostics.error({}, fmt::format("'{}' has no finite values for these directions", target.name()));
    return std::nullopt;
  }
  Fit fit;
  fit.target = target;
  fit.terms = terms_of(*lobes, problem, best.x);
  fit.brdf = brdf_of_terms(fit.terms);
  const std::vector<Uncertainty> all = uncertainties(problem, best.x);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t lobe = problem.name(i).lobe;
    fit.parameters.push_back(
        parameter_of(*lobes, problem, i, best.x[i], factor_of(*lobes, lobe, problem, best.x), all[i]));
  }
  for (const Lobe& lobe : *lobes) {
    for (const std::string& held : lobe.held)
      fit.held.push_back(fmt::format("{}{}{}", lobes->size() > 1 ? lobe.info.keyword : "",
                                     lobes->size() > 1 ? " " : "", held));
  }
  measure(observations, fit);
  add_warnings(observations, problem, best, settings.metric, fit);
  fit.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return fit;
}

std::string text_of(const Fit& fit) {
  if (fit.terms.size() == 1) return grf::to_text(fit.terms[0].model) + "\n";
  grf::DefinitionScope scope;
  grf::BrdfModel sum;
  sum.keyword = "combine";
  for (std::size_t i = 0; i < fit.terms.size(); ++i) {
    const std::string name = fmt::format("lobe{}", i + 1);
    scope.definitions.push_back({name, fit.terms[i].model, {}, {}});
    sum.terms.push_back({static_cast<float>(fit.terms[i].weight), {name, {}}});
  }
  scope.definitions.push_back({"fit", sum, {}, {}});
  grf::Scene scene;
  scene.contents.blocks.push_back({scope, {}, {}});
  return grf::to_text(scene);
}

std::vector<std::size_t> ranking(const std::vector<Fit>& fits, Metric metric) {
  std::vector<std::size_t> order(fits.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return fits[a].error(metric).absolute < fits[b].error(metric).absolute;
  });
  return order;
}

}  // namespace fit
