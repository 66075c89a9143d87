#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <optional>
#include <string>
#include <thread>

#include "grf/diagnostics.h"
#include "renderer/command/interruption.h"
#include "renderer/command/render_progress.h"
#include "renderer/transport/bake_checkpoint.h"
#include "renderer/transport/checkpoint.h"
#include "renderer/transport/display_client.h"

namespace command {

/// What goes on beside a render.
struct RunSettings {
  std::string checkpoint;  ///< path; empty: none
  transport::Fingerprint fingerprint;
  std::optional<transport::DisplayAddress> display;
  transport::ViewerCare viewer_care;  ///< of a viewer that is started if none listens there; empty: none is
  std::string title;                  ///< of the displayed image
};

/// Runs a render to its end, or to a signal: resumes it from its checkpoint, keeps that up to date every
/// minute and at the end, and shows progress and the image. False if the checkpoint cannot be resumed from:
/// nothing has then been rendered. That a checkpoint cannot be written, or that there is no viewer, is a
/// warning.
bool run(transport::Render& render, Interruption& interruption, const RunSettings& settings,
         ProgressReport& progress, grf::Diagnostics& diagnostics);

/// The same for a bake, which has no image.
bool run(transport::Bake& bake, Interruption& interruption, const RunSettings& settings,
         ProgressReport& progress, grf::Diagnostics& diagnostics);

/// Runs any work, to its end or to a signal, and calls `watch` every moment meanwhile. Throws what it throws.
template <class Work, class Watch>
void run_watched(Work& work, Interruption& interruption, const Watch& watch) {
  std::atomic<bool> ended = false;
  std::exception_ptr failure;
  interruption.stops(work);
  std::thread worker([&] {
    try {
      work.run();
    } catch (...) {
      failure = std::current_exception();
    }
    ended = true;
  });
  while (!ended) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    watch();
  }
  worker.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace command
