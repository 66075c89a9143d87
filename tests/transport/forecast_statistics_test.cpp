// A long statistical test of forecasts: whether the samples and the time that a render needed lie in the
// stated interval as often as stated. In the environment, FORECAST_SCENES=30 is the number of random scenes
// and ERROR_SCENES=7 replaces the clock as the seed of the first one.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "renderer/transport/processor_clock.h"
#include "tests/transport/bright_scenes.h"

namespace {

using transport::ErrorCheck;
using transport::ForecastValue;
using transport::Render;
using transport::RenderSettings;

unsigned number_from(const char* name, unsigned otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

/// How often forecasts held, over scenes: those of one scene are not independent.
class Coverage {
 public:
  void add(double truth, const ForecastValue& forecast) {
    ++own_count_;
    own_inside_ += truth >= forecast.low && truth <= forecast.high ? 1 : 0;
    widths_ += std::log(forecast.high / forecast.low);
    ++count_;
    inside_ += truth >= forecast.low && truth <= forecast.high ? 1 : 0;
  }
  void end_scene() {
    if (own_count_ > 0) fractions_.push_back(own_inside_ / own_count_);
    own_count_ = 0;
    own_inside_ = 0;
  }
  double mean() const {
    double sum = 0;
    for (const double fraction : fractions_) sum += fraction;
    return sum / static_cast<double>(fractions_.size());
  }
  /// The standard deviation of the mean over scenes.
  double deviation() const {
    double squares = 0;
    for (const double fraction : fractions_) squares += (fraction - mean()) * (fraction - mean());
    const auto scenes = static_cast<double>(fractions_.size());
    return std::sqrt(squares / (scenes - 1) / scenes);
  }
  /// The geometric mean of the upper over the lower bounds.
  double width() const { return std::exp(widths_ / count_); }
  void print(const char* name) const {
    std::printf("%-44s %4.0f forecasts of %zu scenes: inside %.1f %% (+- %.1f), high / low %.2f\n", name,
                count_, fractions_.size(), 100 * mean(), 100 * deviation(), width());
  }

 private:
  double own_count_ = 0;
  double own_inside_ = 0;
  double count_ = 0;
  double inside_ = 0;
  double widths_ = 0;
  std::vector<double> fractions_;
};

struct Coverages {
  Coverage of_prefixes;  ///< forecasts from a render's own first checks
  Coverage of_probes;    ///< forecasts from some of its tiles, in samples
  Coverage of_times;     ///< the time for a known number of samples
};

transport::Convergence convergence_of(const RenderSettings& settings) {
  if (settings.adaptive) return transport::Convergence::Adaptive;
  return settings.pattern == transport::SamplePattern::Independent ? transport::Convergence::Independent
                                                                   : transport::Convergence::Sobol;
}

/// A render to many samples: what renders with any larger target error need is known from its checks.
class LongRender {
 public:
  LongRender(const transport::CompiledScene& scene, const RenderSettings& settings) {
    RenderSettings until = settings;
    until.target_error = 1e-9;
    Render render(scene, until);
    const double before = transport::process_seconds();
    render.run();
    seconds_ = transport::process_seconds() - before;
    checks_ = render.checks();
  }

  const std::vector<ErrorCheck>& checks() const { return checks_; }
  /// Of the processor.
  double seconds() const { return seconds_; }

  /// The samples until a target error; empty if it was not reached.
  std::optional<double> needed_for(double target) const {
    for (const ErrorCheck& check : checks_) {
      if (error_against_target(check.estimate) <= target) return check.samples;
    }
    return std::nullopt;
  }

  /// Adds whether a forecast held, unless that remains unknown: the interval reaches beyond the render, which
  /// has not reached the target.
  void compare(double target, const ForecastValue& forecast, Coverage& coverage) const {
    const double last = checks_.back().samples;
    const auto needed = needed_for(target);
    if (!needed && forecast.high >= last) return;
    if (forecast.median > last) return;
    coverage.add(needed.value_or(2 * last), forecast);
  }

 private:
  std::vector<ErrorCheck> checks_;
  double seconds_ = 0;
};

void study_prefixes(const LongRender& truth, transport::Convergence convergence, Coverage& coverage) {
  for (const double samples : {34, 70, 144}) {
    std::vector<ErrorCheck> known;
    for (const ErrorCheck& check : truth.checks()) {
      if (check.samples <= samples) known.push_back(check);
    }
    if (known.empty() || !(known.back().estimate.error > 0)) continue;
    const transport::Forecast forecast(known, convergence);
    for (const double factor : {1.5, 2.5, 5.0}) {
      const double target = error_against_target(known.back().estimate) / factor;
      truth.compare(target, forecast.samples_for(target), coverage);
    }
  }
}

/// Renders a third of the tiles, but no fewer than a probe does.
void study_probe(const transport::CompiledScene& scene, const LongRender& truth,
                 const RenderSettings& settings, Coverages& coverages) {
  RenderSettings part = settings;
  part.samples = 100;
  const int all = Render(scene, settings).film().tile_count();
  part.probe = {std::max(std::min(all, 24), all / 3), 1e9};
  Render probe(scene, part);
  probe.run();
  const double error = error_against_target(probe.checks().back().estimate);
  if (!(error > 0)) return;
  for (const double factor : {0.7, 1.5, 2.5}) {
    const transport::TargetForecast forecast = probe.forecasts({error / factor}).front();
    truth.compare(error / factor, forecast.samples, coverages.of_probes);
  }
  // The thread count of forecasts is that of the settings.
  const auto cost = cost_of_image(probe.checks(), part.probe->tiles, probe.rendered_fraction());
  const double samples = truth.checks().back().samples;
  coverages.of_times.add(truth.seconds() / settings.threads, cost.seconds_for({samples, samples, samples}));
}

void study(test::SampleScene scene, double paths, Coverages& coverages) {
  RenderSettings& settings = scene.settings;
  settings.threads = 2;
  settings.samples = std::min(2000, static_cast<int>(paths / settings.width / settings.height));
  for (const char* mode : {"sobol", "adaptive", "independent"}) {
    settings.adaptive = mode == std::string("adaptive");
    const bool is_independent = mode == std::string("independent");
    settings.pattern =
        is_independent ? transport::SamplePattern::Independent : transport::SamplePattern::Sobol;
    const LongRender truth(scene.scene, settings);
    study_prefixes(truth, convergence_of(settings), coverages.of_prefixes);
    study_probe(scene.scene, truth, settings, coverages);
  }
  for (Coverage* one : {&coverages.of_prefixes, &coverages.of_probes, &coverages.of_times}) one->end_scene();
  std::printf("%s\n", scene.name.c_str());
  std::fflush(stdout);
}

void expect_as_stated(const Coverage& coverage, const char* name) {
  coverage.print(name);
  EXPECT_GT(coverage.mean(), transport::Forecast::Coverage - 3 * coverage.deviation() - 0.01) << name;
}

double paths_per_render() { return 1e5 * number_from("FORECAST_PATHS", 30); }

void expect_as_stated(const Coverages& coverages) {
  expect_as_stated(coverages.of_prefixes, "samples, from the render's first checks");
  expect_as_stated(coverages.of_probes, "samples, from a probe of a third of the tiles");
  expect_as_stated(coverages.of_times, "time per sample");
  // An interval may be right more often than stated over so few scenes, but a wide one says little.
  EXPECT_LT(coverages.of_prefixes.width(), 4);
  EXPECT_LT(coverages.of_probes.width(), 2.5);
  EXPECT_LT(coverages.of_times.width(), 1.6);
}

TEST(Forecast, HoldsAsOftenAsStatedOverTheSamples) {
  Coverages coverages;
  for (const std::string& path : test::sample_op_files()) {
    test::SampleScene scene = test::sample_scene(path);
    scene.settings.width = 112;
    scene.settings.height = 84;
    study(std::move(scene), paths_per_render(), coverages);
  }
  expect_as_stated(coverages);
}

TEST(Forecast, HoldsAsOftenAsStatedOverRandomScenes) {
  const unsigned first = number_from("ERROR_SCENES", std::random_device()() % 1'000'000);
  std::printf("ERROR_SCENES=%u\n", first);
  Coverages coverages;
  for (unsigned i = 0; i < number_from("FORECAST_SCENES", 30); ++i) {
    study(test::random_case(first + i).scene, paths_per_render(), coverages);
  }
  expect_as_stated(coverages);
}

}  // namespace
