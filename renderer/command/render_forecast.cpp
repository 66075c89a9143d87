#include "renderer/command/render_forecast.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/command/json_values.h"
#include "renderer/command/render_progress.h"
#include "renderer/command/render_run.h"
#include "renderer/job/camera_path.h"
#include "renderer/job/render_job.h"
#include "renderer/job/target_pilot.h"
#include "renderer/parallel/loops.h"

namespace command {
namespace {

using grf::Diagnostics;
using grf::ExitCode;
using options::RenderOptions;
using transport::Render;
using transport::RenderSettings;
using transport::TargetForecast;

/// The tiles and samples per pixel of the short render that measures how fast the probe will be.
constexpr int TrialTiles = 16;
constexpr int TrialSamples = 4;
/// The samples per pixel that a probe aims at, rather than at more tiles: the exponent of the error's
/// convergence shows over a factor of some samples only.
constexpr double ProbeSamples = 100;
/// The fewest tiles of a probe, of an image that has so many: the error of an image is spread unevenly.
constexpr int LeastTiles = 24;
/// The fewest error checks for a forecast before the end of the probe.
constexpr std::size_t FewestChecks = 3;

RenderSettings without_limits(RenderSettings settings) {
  settings.samples = RenderSettings::Unlimited;
  settings.target_error.reset();
  settings.max_seconds.reset();
  return settings;
}

/// A short render that measures the cost of a path, and the probe, which is sized by that; for the target
/// errors whose renders have the same paths.
struct Probe {
  RenderSettings settings;
  std::vector<double> targets;
  std::optional<Render> trial;
  std::optional<Render> render;
};

/// Returns the probes for some targets, in the order of these.
std::deque<Probe> probes_for(const std::vector<double>& targets,
                             const std::vector<transport::Truncation>& pilot,
                             const RenderSettings& settings) {
  std::deque<Probe> probes;
  for (const double target : targets) {
    RenderSettings own = settings;
    if (const auto truncation = transport::truncation_for(pilot, target)) follow(*truncation, own);
    if (probes.empty() || own.integrator.depth != probes.back().settings.integrator.depth) {
      probes.emplace_back().settings = std::move(own);
    }
    probes.back().targets.push_back(target);
  }
  return probes;
}

/// Shows the forecasts of probes, of which the last one is still running: where other programs are busy, it
/// takes long.
void show_progress(const std::deque<Probe>& probes, double seconds, ProgressReport& report) {
  if (!report.is_due()) return;
  transport::RenderProgress progress;
  for (const Probe& probe : probes) {
    if (!probe.render) break;
    const std::vector<transport::ErrorCheck> checks = probe.render->checks();
    if (checks.size() < FewestChecks) break;
    progress.seconds += checks.back().seconds;
    progress.estimated_error = with_bias(checks.back().estimate, probe.settings.bias).error;
    if (!report.has_forecasts()) continue;
    for (const TargetForecast& forecast : probe.render->forecasts(probe.targets)) {
      progress.forecasts.push_back(forecast);
    }
  }
  progress.done = std::min(0.99, progress.seconds / seconds);
  if (progress.estimated_error) report.show(progress);
}

/// Renders a probe that takes about this many seconds of the processor per thread, unless a signal stops it.
template <class Show>
void run_probe(const transport::CompiledScene& scene, double seconds, SignalHandler& signal_handler,
               Probe& probe, const Show& show) {
  RenderSettings settings = without_limits(probe.settings);
  settings.probe = {TrialTiles, seconds};
  settings.samples = TrialSamples;
  probe.trial.emplace(scene, settings);
  run_watched(*probe.trial, signal_handler, [] {});
  if (signal_handler.was_signalled()) return;
  const transport::ErrorCheck trial = probe.trial->checks().back();
  const int all = probe.trial->film().tile_count();
  const double seconds_per_tile = trial.seconds / trial.samples / std::min(TrialTiles, all);
  const double affordable = (seconds - trial.seconds) / (seconds_per_tile * ProbeSamples);
  settings.probe = {static_cast<int>(std::clamp<double>(affordable, std::min(LeastTiles, all), all)),
                    seconds - trial.seconds};
  settings.samples = RenderSettings::Unlimited;
  probe.render.emplace(scene, settings);
  run_watched(*probe.render, signal_handler, show);
}

struct ForecastReport {
  std::string scene;
  const Render& probe;
  double setup_seconds = 0;
  int frames = 1;
  bool is_one_line = false;  ///< of JSON
  std::vector<TargetForecast> forecasts;

  int threads() const { return parallel::threads_for(probe.settings().threads); }
};

void print_json(const ForecastReport& report) {
  const transport::ErrorCheck check = report.probe.checks().back();
  nlohmann::ordered_json object;
  object["width"] = report.probe.settings().width;
  object["height"] = report.probe.settings().height;
  object["frames"] = report.frames;
  object["threads"] = report.threads();
  object["setup_seconds"] = report.setup_seconds;
  object["probe"] = {{"seconds", check.seconds + check.check_seconds},
                     {"fraction", report.probe.rendered_fraction()},
                     {"samples", check.samples},
                     {"estimated_error", check.estimate.error},
                     {"estimated_error_interval", {check.estimate.low, check.estimate.high}}};
  object["probability"] = transport::Forecast::Coverage;
  object["forecasts"] = json_of(report.forecasts);
  fmt::print("{}\n", json_text(object, report.is_one_line));
}

std::string reached_time_text(double seconds) {
  return std::isfinite(seconds) ? duration_text(seconds) : "never";
}

void print_text(const ForecastReport& report) {
  const RenderSettings& settings = report.probe.settings();
  fmt::print("{}: {}x{} pixels, {} threads, setup {}{}\n", report.scene, settings.width, settings.height,
             report.threads(), duration_text(report.setup_seconds),
             report.frames > 1 ? fmt::format(", each of {} frames:", report.frames) : "");
  for (const TargetForecast& forecast : report.forecasts) {
    fmt::print("  error {:>4.3g} %: {} (with {:.0f} % probability {} to {}), {:.3g} samples per pixel\n",
               100 * forecast.target_error, reached_time_text(forecast.seconds.median),
               100 * transport::Forecast::Coverage, reached_time_text(forecast.seconds.low),
               reached_time_text(forecast.seconds.high), forecast.samples.median);
  }
}

/// Reports an error if the number of samples determines where they are.
bool can_forecast(const RenderSettings& settings, Diagnostics& diagnostics) {
  if (settings.pixel_sampling == transport::PixelSampling::Sobol) return true;
  diagnostics.error(
      {},
      "cannot forecast the error of a render whose samples are not random in the pixel: with the "
      "integrator naive, BPT_Pixel_Random is needed, without BPT_Pixel_Radial and BPT_RayCasting");
  return false;
}

}  // namespace

ExitCode forecast(const RenderArguments& arguments, RenderOptions render_options, const Diagnostics& before) {
  const auto start = std::chrono::steady_clock::now();
  std::deque<Probe> probes;
  SignalHandler signal_handler;  // destroyed before the renders that it stops
  Diagnostics diagnostics = before;
  const std::vector<int> frames = job::frames_of(render_options);
  if (!frames.empty()) render_options.frame = frames.front();
  const auto job = job::render_job(render_options, diagnostics);
  const bool is_possible = job && can_forecast(job->settings, diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (!is_possible) return ExitCode::BadInput;
  probes = probes_for(transport::forecast_targets(job->settings.target_error),
                      job::target_pilot(render_options, *job), job->settings);
  const double setup_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ProgressReport progress(progress_style_of(arguments.progress));
  std::vector<TargetForecast> forecasts;
  for (Probe& probe : probes) {
    run_probe(job->scene, arguments.forecast_seconds / static_cast<double>(probes.size()), signal_handler,
              probe, [&] { show_progress(probes, arguments.forecast_seconds, progress); });
    if (signal_handler.was_signalled()) return ExitCode::Interrupted;
    for (const TargetForecast& forecast : probe.render->forecasts(probe.targets)) {
      forecasts.push_back(forecast);
    }
  }
  const ForecastReport report = {arguments.scene,
                                 *probes.back().render,
                                 setup_seconds,
                                 std::max(1, static_cast<int>(frames.size())),
                                 arguments.progress == "json",
                                 forecasts};
  arguments.json ? print_json(report) : print_text(report);
  return ExitCode::Done;
}

}  // namespace command
