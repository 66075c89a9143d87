#include "renderer/command/render_run.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

namespace command {
namespace {

using Clock = std::chrono::steady_clock;

/// Keeps the checkpoint of a render or a bake up to date.
template <class Work>
class CheckpointKeeper {
 public:
  CheckpointKeeper(const Work& work, const RunSettings& settings) : work_(work), settings_(settings) {}

  void keep_if_due() {
    if (settings_.checkpoint.empty() || Clock::now() < due_) return;
    grf::Diagnostics diagnostics;
    keep(diagnostics);
    fmt::print(stderr, "{}", diagnostics.to_text());
  }

  void keep(grf::Diagnostics& diagnostics) {
    if (settings_.checkpoint.empty()) return;
    const auto start = Clock::now();
    grf::Diagnostics problems;
    if (!write_checkpoint(settings_.checkpoint, settings_.fingerprint, work_, problems)) {
      // The result is worth more than the checkpoint, so the work continues.
      for (const auto& problem : problems.entries()) diagnostics.warning(problem.location, problem.message);
    }
    // A checkpoint of a huge image takes long: it may take 1/20 of the time at most.
    const auto end = Clock::now();
    due_ = end + std::max<Clock::duration>(Interval, 20 * (end - start));
  }

 private:
  static constexpr std::chrono::seconds Interval{60};

  const Work& work_;
  const RunSettings& settings_;
  Clock::time_point due_ = Clock::now() + Interval;
};

void show_progress(const transport::Render& render, ProgressReport& report) {
  if (!report.is_due()) return;
  transport::RenderProgress progress = render.progress();
  if (report.has_forecasts() && !render.checks().empty()) {
    progress.forecasts = render.forecasts(transport::forecast_targets(render.settings().target_error));
  }
  report.show(progress);
}

void print_problem(std::optional<display::Client>& display) {
  if (!display) return;
  if (const auto problem = display->take_problem()) fmt::print(stderr, "warning: {}\n", *problem);
}

/// Waits for the image viewer, which may start more slowly than a short render takes.
void wait_for_viewer(const display::Client& display, const SignalHandler& signal_handler) {
  while (display.is_connecting() && !signal_handler.was_signalled()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

template <class Work>
bool resume(Work& work, const RunSettings& settings, grf::Diagnostics& diagnostics) {
  return settings.checkpoint.empty() ||
         resume_from_checkpoint(settings.checkpoint, settings.fingerprint, work, diagnostics);
}

}  // namespace

bool run(transport::Render& render, SignalHandler& signal_handler, const RunSettings& settings,
         ProgressReport& progress, grf::Diagnostics& diagnostics) {
  if (!resume(render, settings, diagnostics)) return false;
  std::optional<display::Client> display;
  if (settings.display) display.emplace(render, *settings.display, settings.title, settings.viewer_launcher);
  CheckpointKeeper<transport::Render> checkpoint(render, settings);
  const auto watch = [&] {
    show_progress(render, progress);
    print_problem(display);
    checkpoint.keep_if_due();
  };
  run_watched(render, signal_handler, watch);
  checkpoint.keep(diagnostics);
  if (display && settings.viewer_launcher) wait_for_viewer(*display, signal_handler);
  if (display) display->finish();
  print_problem(display);
  return true;
}

bool run(bake::Bake& bake, SignalHandler& signal_handler, const RunSettings& settings,
         ProgressReport& progress, grf::Diagnostics& diagnostics) {
  if (!resume(bake, settings, diagnostics)) return false;
  CheckpointKeeper<bake::Bake> checkpoint(bake, settings);
  const auto watch = [&] {
    progress.show(bake.progress());
    checkpoint.keep_if_due();
  };
  run_watched(bake, signal_handler, watch);
  checkpoint.keep(diagnostics);
  return true;
}

}  // namespace command
