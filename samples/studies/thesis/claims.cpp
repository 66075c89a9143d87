#include "samples/studies/thesis/claims.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "samples/studies/thesis/equal_time.h"
#include "samples/studies/thesis/lobe_fit.h"

namespace study {
namespace {

/// Means over the BRDFs of one scene, at the largest sample count; NaN if there is no row.
class Means {
 public:
  Means(const Results& results, std::string scene, std::string integrator = "naive")
      : results_(results), scene_(std::move(scene)), integrator_(std::move(integrator)) {
    const std::vector<int> counts = results.counts({scene_, {}, {}, integrator_});
    if (counts.size() > 1) before_last_ = counts[counts.size() - 2];
    if (!counts.empty()) last_ = counts.back();
  }
  int last() const { return last_; }
  double operator()(std::string_view technique, const Quantity& quantity) const {
    return results_.mean({scene_, {}, technique, integrator_, last_}, quantity).value_or(NAN);
  }
  double error(std::string_view technique) const { return (*this)(technique, percent); }

  /// Rate of convergence up to the largest sample count, from where most pixels have hit a light.
  double exponent(std::string_view technique) const {
    return std::log(error_with(technique, exponent_from()) / error(technique)) /
           std::log(static_cast<double>(last_) / exponent_from());
  }
  int exponent_from() const { return last_ > 100 ? 100 : 25; }
  /// The error at the second largest sample count, over that at the largest.
  double last_gain(std::string_view technique) const {
    return error_with(technique, before_last_) / error(technique);
  }
  int before_last() const { return before_last_; }

 private:
  const Results& results_;
  std::string scene_, integrator_;
  int before_last_ = 0, last_ = 0;

  double error_with(std::string_view technique, int samples) const {
    return results_.mean({scene_, {}, technique, integrator_, samples}, percent).value_or(NAN);
  }
};

std::string ratio(double a, double b) { return figure(a / b); }

/// Checks the claim that a technique has no larger error than others.
Verdict least_error(const Means& means, const std::string& claim, const std::string& technique,
                    const std::vector<std::string>& others) {
  const std::string best = *std::min_element(others.begin(), others.end(), [&](const auto& a, const auto& b) {
    return means.error(a) < means.error(b);
  });
  const double mine = means.error(technique);
  return {claim, mine <= means.error(best),
          fmt::format("{} % with {} samples, and {} % by `{}`, the best of the others", figure(mine),
                      means.last(), figure(means.error(best)), best)};
}

/// Returns the error of a technique, mean over the BRDFs, in the time that another takes for its most
/// samples. Nothing if the tables are not built by then for any BRDF.
std::optional<double> error_in_time_of(const Results& results, const std::string& scene,
                                       const RowFilter& line, const RowFilter& other) {
  double sum = 0;
  int count = 0;
  for (const std::string& brdf : results.names({scene}, &Row::brdf)) {
    const auto rows = results.select({scene, brdf, line.technique, line.integrator});
    const auto others = results.select({scene, brdf, other.technique, other.integrator});
    if (rows.empty() || others.empty()) continue;
    const auto error = Curve(rows).error_at(Curve(others).last_total());
    if (!error) continue;
    sum += 100 * *error;
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

/// Formats an error at a time.
std::string percent_or_none(const std::optional<double>& error) {
  return error ? fmt::format("{} %", figure(*error)) : "none, because its tables are not built by then";
}

/// Returns the rate of convergence of a printed row, from 10² to 50².
double printed_exponent(const PrintedTable& table, std::string_view technique) {
  const auto a = table.value(technique, 100);
  const auto b = table.value(technique, 2500);
  return a && b ? std::log(*a / *b) / std::log(25.0) : NAN;
}

double printed_ratio(const PrintedTable& table, std::string_view a, std::string_view b, int samples = 2500) {
  return table.value(a, samples).value_or(NAN) / table.value(b, samples).value_or(NAN);
}

Verdict slower(const Means& means, const PrintedTable& times, const std::string& slow,
               const std::string& fast) {
  const double today = means(slow, sampling) / means(fast, sampling);
  return {fmt::format("sampling directions by `{}` takes longer than by `{}` (thesis: {} times)", slow, fast,
                      figure(printed_ratio(times, slow, fast))),
          today > 1, fmt::format("{} times", figure(today))};
}

/// Checks convergence: the error of an unbiased estimator keeps falling; that of a biased one, or against a
/// wrong reference, does not.
Verdict converges(const Means& means, const PrintedTable& errors, const std::string& technique) {
  constexpr double Most = 0.7;
  const auto left = [](double exponent) { return std::pow(4, -exponent); };
  const double today = left(means.exponent(technique));
  return {fmt::format(
              "four times the samples reduce the error of `{}` to less than {} of it (an unbiased estimator "
              "with independent samples reaches 0.5; thesis: {}, from 10² to 50²)",
              technique, Most, figure(left(printed_exponent(errors, technique)))),
          today < Most,
          fmt::format("to {} of it, from {} to {}", figure(today), means.exponent_from(), means.last())};
}

}  // namespace

std::vector<Verdict> cornell_claims(const Results& results, const PrintedTables& printed) {
  const Means means(results, "cornell_box");
  const PrintedTable& times = printed.table("5.7");
  const PrintedTable& errors = printed.table("5.8");
  const double uniform = means.error("uniform");
  const auto reject =
      error_in_time_of(results, "cornell_box", {{}, {}, "reject", "naive"}, {{}, {}, "uniform", "naive"});
  return {slower(means, times, "reject", "uniform"),
          least_error(means, "the thesis' method has the least error at equal samples", "reject",
                      {"uniform", "sphere-best", "hemisphere-best"}),
          {"uniform sampling is more efficient here: it has less error than the thesis' method in the same "
           "time",
           !reject || uniform < *reject,
           fmt::format("{} % against {}", figure(uniform), percent_or_none(reject))},
          converges(means, errors, "uniform"),
          converges(means, errors, "reject")};
}

std::vector<Verdict> constant_claims(const Results& results, const PrintedTables& printed) {
  const Means means(results, "glossy_sphere");
  const PrintedTable& times = printed.table("5.9");
  const PrintedTable& errors = printed.table("5.10");
  const std::vector<std::string> others = {"uniform", "sphere", "hemisphere", "factored"};
  const auto worst = std::max_element(others.begin(), others.end(), [&](const auto& a, const auto& b) {
    return means.error(a) < means.error(b);
  });
  return {
      slower(means, times, "reject", "uniform"),
      slower(means, times, "hemisphere", "reject"),
      slower(means, times, "factored", "reject"),
      least_error(means, "without manual adjustment the thesis' method has the least error at equal samples",
                  "reject", others),
      least_error(means, "and so does `warp`", "warp", others),
      {"factors with the same parameters for all BRDFs are the worst (thesis: 64 % at 50², 2.8 times the "
       "best)",
       *worst == "factored", fmt::format("`{}` is, with {} %", *worst, figure(means.error(*worst)))},
      {"the error of the thesis' method has stopped falling: the next step reduces it by less than a tenth "
       "(thesis: from 22.6 % at 30² to 22.5 % at 40², and at 1000²)",
       means.last_gain("reject") < 1.1,
       fmt::format("from {} to {} samples it falls to {} %, 1 / {} of what it was", means.before_last(),
                   means.last(), figure(means.error("reject")), figure(means.last_gain("reject")))},
      converges(means, errors, "reject")};
}

std::vector<Verdict> adjusted_claims(const Results& results, const PrintedTables& printed) {
  const Means means(results, "glossy_sphere");
  const PrintedTable& times = printed.table("5.11");
  const PrintedTable& errors = printed.table("5.12");
  const std::vector<std::string> others = {"uniform", "sphere-best", "hemisphere-best", "factored-best"};
  const double gain = means.error("factored") / means.error("factored-best");
  const double printed_gain = printed.table("5.10").value("factored", 2500).value_or(NAN) /
                              errors.value("factored-best", 2500).value_or(NAN);
  const double lobes = means.error("hemisphere-best") / means.error("reject");
  return {
      slower(means, times, "factored-best", "reject"),
      least_error(means, "the thesis' method has the least error at equal samples, against adjusted ones too",
                  "reject", others),
      least_error(means, "and so does `warp`", "warp", others),
      {fmt::format(
           "adjusted lobes come within a tenth of the thesis' method (thesis: {} times its error at 50²)",
           figure(printed_ratio(errors, "hemisphere-best", "reject"))),
       lobes < 1.1, fmt::format("{} times", figure(lobes))},
      {fmt::format("adjusting the factors reduces their error (thesis: {} times at 50²)",
                   figure(printed_gain)),
       gain > 1.05, fmt::format("{} times", figure(gain))},
      converges(means, errors, "hemisphere-best")};
}

std::vector<Verdict> dragon_claims(const Results& results) {
  const Means means(results, "dragon");
  const double times = means("reject", sampling) / means("uniform", sampling);
  return {{"sampling directions by the thesis' method takes the longest (thesis: 42.6 s, 4.37 times that of "
           "`uniform`)",
           means("reject", sampling) > means("factored-best", sampling) &&
               means("reject", sampling) > means("hemisphere-best", sampling),
           fmt::format("{} s, {} times; the lobes {} s, the factors {} s", figure(means("reject", sampling)),
                       figure(times), figure(means("hemisphere-best", sampling)),
                       figure(means("factored-best", sampling)))},
          least_error(means, "the thesis' method has the least noise", "reject",
                      {"uniform", "hemisphere-best", "factored-best"})};
}

std::vector<Verdict> pottery_claims(const Results& results, const PrintedTables& printed) {
  const Means means(results, "pottery");
  const PrintedTable& errors = printed.table("5.15");
  const double trees = means("reject", build);
  const double factors = means("factored-fine", build);
  const double worse = means.error("factored-fine") / means.error("reject");
  const double finer = means.error("factored-best") / means.error("factored-fine");
  return {{fmt::format("the quadtrees are built faster than the factors (thesis: {} times at 50²)",
                       figure(printed_ratio(printed.table("5.13"), "factored-fine", "reject"))),
           trees < factors,
           fmt::format("{} s against {} s; `warp` {} s", figure(trees), figure(factors),
                       figure(means("warp", build)))},
          slower(means, printed.table("5.14"), "reject", "factored-fine"),
          {fmt::format("the error of the factors is over twice that of the quadtrees at equal samples "
                       "(thesis: {} times at 50²)",
                       figure(printed_ratio(errors, "factored-fine", "reject"))),
           worse > 2, fmt::format("{} times", figure(worse))},
          {"finer factors change the error by less than a fifth", finer < 1.2 && finer > 1 / 1.2,
           fmt::format("{} times", figure(1 / finer))},
          least_error(means, "`warp` has the least error at equal samples of all generic schemes", "warp",
                      {"uniform", "hemisphere-best", "factored-best", "factored-fine", "cascade", "reject"}),
          converges(means, errors, "factored-fine"),
          converges(means, errors, "reject")};
}

std::vector<Verdict> jug_claims(const Results& results, const PrintedTables& printed) {
  const Means naive(results, "jug");
  const Means path(results, "jug", "path");
  const PrintedTable& errors = printed.table("5.18");
  const double with = path.error("reject-ris");
  const double without = naive.error("reject");
  const auto resampled =
      error_in_time_of(results, "jug", {{}, {}, "warp-ris", "path"}, {{}, {}, "warp", "path"});
  return {
      {fmt::format("the factors are built faster than the quadtrees (thesis: {} times at 50²)",
                   figure(printed_ratio(printed.table("5.16"), "reject", "factored"))),
       naive("factored", build) < naive("reject", build),
       fmt::format("{} s against {} s; `warp` {} s", figure(naive("factored", build)),
                   figure(naive("reject", build)), figure(naive("warp", build)))},
      {fmt::format("resampling reduces the error of the quadtrees (thesis: {} times at 50²)",
                   figure(printed_ratio(errors, "reject", "reject-ris"))),
       with < without,
       fmt::format(
           "from {} % to {} % with {} samples, and with multiple importance sampling instead it is {} %",
           figure(without), figure(with), path.last(), figure(path.error("reject")))},
      {fmt::format("and that of the factors (thesis: {} times)",
                   figure(printed_ratio(errors, "factored", "factored-ris"))),
       path.error("factored-ris") < naive.error("factored"),
       fmt::format("from {} % to {} %", figure(naive.error("factored")), figure(path.error("factored-ris")))},
      least_error(path, "of the techniques with resampling the thesis' method has the least error",
                  "reject-ris", {"uniform-ris", "factored-ris"}),
      {"resampling is efficient: `warp` has less error with it than without it in the same time",
       resampled && *resampled < path.error("warp"),
       fmt::format("{} against {} %", percent_or_none(resampled), figure(path.error("warp")))}};
}

std::vector<Verdict> measured_claims(const Results& results, const PrintedTables& printed) {
  const Means means(results, "measured");
  const auto kilobytes = [](const Row& row) { return row.bytes / 1024; };
  const auto seconds = [&](const char* technique) { return figure(means(technique, build)); };
  const std::vector<double>& memory = printed.table("5.19").means;
  return {{"the quadtrees take longer to build than the tables, and far less than compressed tables (thesis: "
           "68.1, 29.6 and 2091 s)",
           means("reject", build) > means("cascade", build) &&
               means("reject", build) < 0.5 * means("compressed", build),
           fmt::format("{}, {} and {} s; `warp` {} s", seconds("reject"), seconds("cascade"),
                       seconds("compressed"), seconds("warp"))},
          {fmt::format("the quadtrees need the least memory (thesis: {} KB, {} and {} for the tables)",
                       figure(memory[5]), figure(memory[3]), figure(memory[4])),
           means("reject", kilobytes) < means("compressed", kilobytes) &&
               means("reject", kilobytes) < means("cascade", kilobytes),
           fmt::format("{} KB, {} and {}; `warp` {}", figure(means("reject", kilobytes)),
                       figure(means("cascade", kilobytes)), figure(means("compressed", kilobytes)),
                       figure(means("warp", kilobytes)))},
          {"sampling by the quadtrees takes the longest (thesis: 15.2 s, and 2.41, 1.02 and 0.35)",
           means("reject", sampling) > means("cascade", sampling) &&
               means("reject", sampling) > means("compressed", sampling),
           fmt::format("{} s, and {}, {} and {}; `warp` {}", figure(means("reject", sampling)),
                       figure(means("cascade", sampling)), figure(means("compressed", sampling)),
                       figure(means("uniform", sampling)), figure(means("warp", sampling)))},
          least_error(means, "the quadtrees have the least noise", "reject",
                      {"uniform", "cascade", "compressed"}),
          least_error(means, "and so does `warp`", "warp", {"uniform", "cascade", "compressed"})};
}

std::vector<Verdict> lobe_claims() {
  const auto brdf = brdf_of("lewis n=32.5 ks=0.5 kd=0.5");
  const auto lobe_alone = brdf_of("lewis n=32.5 ks=0.5 kd=0");
  const double best = best_lobe_exponent(brdf);
  const double best_alone = best_lobe_exponent(lobe_alone);
  return {
      {"a lobe with exponent 16 fits this BRDF better than one with the BRDF's own exponent, 32.5",
       total_variation_distance(brdf, 16) < total_variation_distance(brdf, 32.5),
       fmt::format("the total variation distance is {} against {}; its minimum, {}, is at {:g}, and with "
                   "kd = 0 at {:g}",
                   figure(total_variation_distance(brdf, 16)), figure(total_variation_distance(brdf, 32.5)),
                   figure(total_variation_distance(brdf, best)), best, best_alone)}};
}

std::string changes(const Results& results, const std::string& scene, const PrintedTable& errors) {
  const Means naive(results, scene);
  const Means path(results, scene, "path");
  const RowFilter ours = {{}, {}, "warp", "path"};
  const RowFilter theirs = {{}, {}, "reject", "naive"};
  const auto now = error_in_time_of(results, scene, ours, theirs);
  if (!now) return {};
  const double then = naive.error("reject");
  std::string text = fmt::format(
      "\nSpeed-up: in the time of {} samples of the thesis' estimator with its method ({} % error), `path` "
      "with `warp` reaches {} %, {} of that error.",
      naive.last(), figure(then), figure(*now), ratio(*now, then));
  const double printed = printed_exponent(errors, "reject");
  if (std::isfinite(printed)) {
    text += fmt::format(
        " The error of the thesis' method falls as N^-r with r = {} in print and r = {} today{}.",
        figure(printed), figure(naive.exponent("reject")),
        printed < 0.3
            ? ": the printed errors level off, so they are errors of the reference rather than of the samples"
            : "");
  }
  return text + "\n";
}

}  // namespace study
