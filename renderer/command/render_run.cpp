#include "renderer/command/render_run.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

#include <fmt/format.h>

namespace command {
namespace {

using Clock = std::chrono::steady_clock;

/// Keeps a render's checkpoint up to date.
class CheckpointKeeper {
 public:
  CheckpointKeeper(const transport::Render& render, const RunSettings& settings)
      : render_(render), settings_(settings) {}

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
    if (!write_checkpoint(settings_.checkpoint, settings_.fingerprint, render_, problems)) {
      // The image is worth more than the checkpoint: the render goes on.
      for (const auto& problem : problems.entries()) diagnostics.warning(problem.location, problem.message);
    }
    // One of a huge image takes long: it must not be all that is done.
    const auto end = Clock::now();
    due_ = end + std::max<Clock::duration>(Interval, 20 * (end - start));
  }

 private:
  static constexpr std::chrono::seconds Interval{60};

  const transport::Render& render_;
  const RunSettings& settings_;
  Clock::time_point due_ = Clock::now() + Interval;
};

void say_problem(std::optional<transport::DisplayClient>& display) {
  if (!display) return;
  if (const auto problem = display->take_problem()) fmt::print(stderr, "warning: {}\n", *problem);
}

}  // namespace

bool run(transport::Render& render, Interruption& interruption, const RunSettings& settings,
         ProgressReport& progress, grf::Diagnostics& diagnostics) {
  if (!settings.checkpoint.empty() &&
      !resume_from_checkpoint(settings.checkpoint, settings.fingerprint, render, diagnostics)) {
    return false;
  }
  std::optional<transport::DisplayClient> display;
  if (settings.display) display.emplace(render, *settings.display, settings.title);
  std::atomic<bool> ended = false;
  std::exception_ptr failure;
  interruption.stops(render);
  std::thread worker([&] {
    try {
      render.run();
    } catch (...) {
      failure = std::current_exception();
    }
    ended = true;
  });
  CheckpointKeeper checkpoint(render, settings);
  while (!ended) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    progress.show(render.progress());
    checkpoint.keep_if_due();
    say_problem(display);
  }
  worker.join();
  if (failure) std::rethrow_exception(failure);
  checkpoint.keep(diagnostics);
  if (display) display->finish();
  say_problem(display);
  return true;
}

}  // namespace command
