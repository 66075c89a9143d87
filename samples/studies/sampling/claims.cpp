#include "samples/studies/sampling/claims.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "samples/studies/sampling/tables.h"

namespace study {
namespace {

using Number = std::function<double(const CaseResult&)>;

double mean_of_cases(const Results& results, const Number& number) {
  double sum = 0;
  for (const CaseResult& one : results.cases) sum += number(one);
  return sum / static_cast<double>(results.cases.size());
}

struct Extreme {
  double value = 0;
  std::string name;
};

Extreme largest(const Results& results, const Number& number) {
  const auto found =
      std::max_element(results.cases.begin(), results.cases.end(),
                       [&](const CaseResult& a, const CaseResult& b) { return number(a) < number(b); });
  return {number(*found), found->subject->name};
}

Extreme least(const Results& results, const Number& number) {
  const Extreme found = largest(results, [&](const CaseResult& one) { return -number(one); });
  return {-found.value, found.name};
}

std::size_t count(const Results& results, const std::function<bool(const CaseResult&)>& is_so) {
  return static_cast<std::size_t>(std::count_if(results.cases.begin(), results.cases.end(), is_so));
}

std::size_t glossy_count(const Results& results) {
  return count(results, [](const CaseResult& one) { return one.is_glossy; });
}

/// A kind of points and a light.
struct Condition {
  Light light;
  Points points;
};

Error error_of(const CaseResult& one, TechniqueId id, const Condition& condition) {
  return one[id].error(condition.light, condition.points, MostSamples);
}

/// Returns true if the first exceeds so many times the second beyond the noise of both.
bool exceeds(const Error& first, double times, const Error& second) {
  const double noise = std::hypot(first.noise(), second.noise());
  return first.value() > times * second.value() * (1 + 2 * noise);
}

/// The result of one scheme against some others on the glossy BRDFs.
struct Contest {
  std::size_t won = 0;
  std::string lost;  ///< "phong (1.3 times that of `sphere-best`), ..."
};

Contest contest(const Results& results, TechniqueId id, const std::vector<TechniqueId>& others, double times,
                const Condition& condition) {
  Contest result;
  for (const CaseResult& one : results.cases) {
    if (!one.is_glossy) continue;
    const Error error = error_of(one, id, condition);
    const TechniqueId rival =
        *std::min_element(others.begin(), others.end(), [&](TechniqueId a, TechniqueId b) {
          return error_of(one, a, condition).square < error_of(one, b, condition).square;
        });
    if (!exceeds(error, times, error_of(one, rival, condition))) {
      ++result.won;
      continue;
    }
    result.lost +=
        fmt::format("{}{} ({:.2f} times that of `{}`)", result.lost.empty() ? "" : ", ", one.subject->name,
                    error.value() / error_of(one, rival, condition).value(), TechniqueNames[rival]);
  }
  return result;
}

std::string words_for(const Contest& contest, std::size_t of) {
  return fmt::format("on {} of {} glossy BRDFs{}", contest.won, of,
                     contest.lost.empty() ? "" : "; not on " + contest.lost);
}

}  // namespace

std::vector<Verdict> build_claims(const Results& results) {
  const double reject = mean_of_cases(results, [](const auto& one) { return one.reject_90.seconds; });
  const double warp = mean_of_cases(results, [](const auto& one) { return one.warp_90.seconds; });
  const double factored = mean_of_cases(results, [](const auto& one) { return one.factored.seconds; });
  const Extreme slowest = largest(results, [](const auto& one) { return one.reject_90.seconds; });
  return {
      {"90 trees take less time to build than the factors, on average (thesis: 94.7 against 105.7 s)",
       reject < factored, fmt::format("`reject` {} s, factors {} s", figure(reject), figure(factored))},
      {"the same of `warp`", warp < factored,
       fmt::format("`warp` {} s, factors {} s", figure(warp), figure(factored))},
      {"he takes the longest to build, over twice the mean (thesis: 452.7 s)",
       slowest.name == "he" && slowest.value > 2 * reject,
       fmt::format("{} takes {} s, {} times the mean", slowest.name, figure(slowest.value),
                   figure(slowest.value / reject))},
  };
}

std::vector<Verdict> tree_claims(const Results& results) {
  const auto mean_kb = [&](std::size_t i) {
    return mean_of_cases(results, [&](const CaseResult& one) { return kilobytes(one.tree_bytes[i]); });
  };
  const double ratio = mean_kb(0) / mean_kb(1);
  return {
      {"n_max = 1.3 is very restrictive: it takes over ten times the memory of 2 (thesis: 78 times)",
       ratio > 10, fmt::format("{} KB against {}", figure(mean_kb(0)), figure(mean_kb(1)))},
      {"2.5 takes less than 2, and 3 takes more than both (thesis: 4.67, 14.5 and 50.1 KB)",
       mean_kb(2) < mean_kb(1) && mean_kb(3) > mean_kb(1),
       fmt::format("{} KB for 2, {} for 2.5, {} for 3; a node that is split for 3 is split for 2 too",
                   figure(mean_kb(1)), figure(mean_kb(2)), figure(mean_kb(3)))},
  };
}

std::vector<Verdict> memory_claims(const Results& results) {
  const auto range = [&](const Number& kb) {
    return std::pair(least(results, kb).value, largest(results, kb).value);
  };
  const auto [reject_least, reject_most] =
      range([](const auto& one) { return kilobytes(one.reject_60.bytes); });
  const auto [warp_least, warp_most] = range([](const auto& one) { return kilobytes(one.warp_60.bytes); });
  const auto [least_kb, most_kb] = range([](const auto& one) { return kilobytes(one.factored.bytes); });
  const std::size_t smaller =
      count(results, [](const CaseResult& one) { return one.reject_60.bytes < one.factored.bytes; });
  const std::size_t smaller_warp =
      count(results, [](const CaseResult& one) { return one.warp_60.bytes < one.factored.bytes; });
  // The thesis' figure minus the matrix of all views and cells, in doubles.
  const auto beside_matrix = [](const CaseResult& one) {
    const FactorParameters& size = one.subject->thesis.factors;
    return one.subject->thesis.factored_kb - 16.0 * 16 * size.rows * size.columns * sizeof(double) / 1024;
  };
  constexpr double Most = 2408;  // KB, of table 5.3
  return {
      {"60 trees take at most 2.4 MB (thesis: 0.006 to 2.4 MB)", reject_most <= Most,
       fmt::format("`reject` without its tables {} to {} KB", figure(reject_least), figure(reject_most))},
      {"the same of `warp`", warp_most <= Most,
       fmt::format("{} to {} KB", figure(warp_least), figure(warp_most))},
      {"the factors take 1 to 6.5 MB, more than the trees on most BRDFs",
       least_kb >= 1000 && 2 * smaller > results.cases.size(),
       fmt::format(
           "factors {} to {} KB; `reject` takes less on {} of {} BRDFs, `warp` on {}. The thesis' "
           "figures are those of the whole matrix in doubles, 16 x 16 views of all cells, and {} to {} "
           "KB: the factors themselves were always small",
           figure(least_kb), figure(most_kb), smaller, results.cases.size(), smaller_warp,
           figure(least(results, beside_matrix).value), figure(largest(results, beside_matrix).value))},
  };
}

std::vector<Verdict> factor_claims(const Results& results) {
  const std::size_t near =
      count(results, [](const CaseResult& one) { return one.factored_distance <= 1.1 * one.found.distance; });
  const std::size_t halves = count(results, [](const CaseResult& one) {
    return one.subject->thesis.factors.half == one.found.parameters.half;
  });
  return {
      {"the parameters of table 5.6 fit best, within 10 %", near == results.cases.size(),
       fmt::format("on {} of {} BRDFs; the choice between direction and half vector is that of the thesis on "
                   "{}",
                   near, results.cases.size(), halves)},
  };
}

std::vector<Verdict> error_claims(const Results& results, Light light) {
  const std::size_t glossy = glossy_count(results);
  const Condition as_thesis = {light, Independent};
  const std::vector<TechniqueId> unset = {Diffuse, Sphere50, Hemisphere50};
  const std::vector<TechniqueId> set = {Diffuse,        Sphere50, SphereBest, Hemisphere50,
                                        HemisphereBest, Factored, Cascade};
  const Contest plain = contest(results, Reject, unset, 1, as_thesis);
  const Contest adjusted = contest(results, Reject, set, 1, as_thesis);
  const Contest warp = contest(results, Warp, set, 1, as_thesis);
  return {
      {"the thesis' method (`reject`), with no parameters to set, has the least error at equal samples of "
       "the schemes without parameters adjusted to the BRDF",
       plain.won == glossy, words_for(plain, glossy)},
      {"and less than those with adjusted parameters and tables", adjusted.won == glossy,
       words_for(adjusted, glossy)},
      {"`warp` has less error than all of these", warp.won == glossy, words_for(warp, glossy)},
  };
}

std::vector<Verdict> targets(const Results& results) {
  const Extreme slowest = largest(results, [](const auto& one) { return one.warp_90.seconds; });
  const auto excess = [](const CaseResult& one) {
    return kilobytes(one.warp_90.bytes) / std::max(256.0, one.subject->thesis.adaptive_kb);
  };
  const Extreme fullest = largest(results, excess);
  const std::size_t small = count(results, [&](const CaseResult& one) { return excess(one) <= 1; });
  const Extreme longest = largest(results, [](const auto& one) { return one[Warp].cost.with_pdf; });
  const std::size_t glossy = glossy_count(results);
  std::vector<Verdict> all = {
      {"90 trees of `warp` build in under 1 s", slowest.value < 1,
       fmt::format("at most {} s, for {}", figure(slowest.value), slowest.name)},
      {"and take at most 256 KB or the memory of table 5.3", fullest.value <= 1,
       fmt::format("{} of {} BRDFs; at most {:.2f} of it, for {}", small, results.cases.size(), fullest.value,
                   fullest.name)},
      {"`warp` draws a sample and its pdf in under 150 ns", longest.value < 150,
       fmt::format("at most {} ns, for {}", figure(longest.value), longest.name)},
  };
  const std::vector<TechniqueId> generic = {Diffuse,        Sphere50, SphereBest, Hemisphere50,
                                            HemisphereBest, Factored, Cascade,    Reject};
  const auto add = [&](const std::string& claim, const std::vector<TechniqueId>& rivals, double times) {
    for (const Light light : LightsByWeight) {
      const Contest sobol = contest(results, Warp, rivals, times, {light, Sobol});
      const Contest independent = contest(results, Warp, rivals, times, {light, Independent});
      all.push_back(
          {fmt::format("{}, {}", claim, LightNames[light]), sobol.won == glossy,
           fmt::format("{}. With independent points on {}", words_for(sobol, glossy), independent.won)});
    }
  };
  add("`warp` has the least error of all generic schemes", generic, 1);
  add("and at most 1.15 times that of the model's own sampler", {Own}, 1.15);
  return all;
}

namespace {

/// Returns true if a scheme has less error than a perfect pdf, with independent points.
bool is_better_than_perfect(const CaseResult& one, TechniqueId id, Light light) {
  const double perfect = one.perfect[light] / std::sqrt(SampleCounts.back());
  return one[id].error(light, Independent, MostSamples).value() < 0.95 * perfect;
}

std::string slow_ones(const Results& results) {
  std::string names;
  for (const CaseResult& one : results.cases) {
    const double time = one[Warp].cost.with_pdf;
    if (time < 150) continue;
    names += fmt::format("{}{} ({} ns)", names.empty() ? "" : ", ", one.subject->name, figure(time));
  }
  if (names.empty()) return {};
  return "- Over 150 ns: " + names +
         ". A sample descends all trees around its view at once, level by level: two for an isotropic BRDF, "
         "three for an anisotropic one.\n";
}

}  // namespace

std::string limits(const Results& results) {
  const auto against_perfect = [&](Light light) {
    return geometric_mean(results.cases, [&](const CaseResult& one) {
      const double perfect = one.perfect[light] / std::sqrt(SampleCounts.back());
      return one[Warp].error(light, Independent, MostSamples).value() / std::max(perfect, 1e-9);
    });
  };
  std::string text = fmt::format(
      "- Compared with perfect importance sampling (pdf proportional to f cos), `warp` has {:.3f} times the "
      "error with a light anywhere, {:.3f} under the environment map and {:.3f} at the highlight (geometric "
      "means over the BRDFs, 256 independent points): better tables could gain no more than this without "
      "Sobol points.\n",
      against_perfect(Anywhere), against_perfect(Environment), against_perfect(Highlight));
  const auto better = [&](TechniqueId id, Light light) {
    return count(results, [&](const CaseResult& one) { return is_better_than_perfect(one, id, light); });
  };
  const std::size_t diffuse = count(results, [](const CaseResult& one) {
    return !one.is_glossy && is_better_than_perfect(one, Sphere50, Highlight);
  });
  text += fmt::format(
      "- No pdf based only on the BRDF is the best for every light. With a single light, a scheme that "
      "happens to sample towards it wins: at the highlight, `sphere-50` has less error than the perfect pdf "
      "on {} of {} BRDFs, {} of them diffuse, and `diffuse` beside it on {}. Over all positions of a small "
      "light, the perfect pdf has the least error: `sphere-50` beats it on {} there, and `diffuse` on {}.\n",
      better(Sphere50, Highlight), results.cases.size(), diffuse, better(Diffuse, Beside),
      better(Sphere50, Anywhere), better(Diffuse, Anywhere));
  return text + slow_ones(results);
}

}  // namespace study
