#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <optional>
#include <string>
#include <thread>

#include "grf/diagnostics.h"
#include "renderer/bake/checkpoint.h"
#include "renderer/command/render_progress.h"
#include "renderer/command/signal_handler.h"
#include "renderer/display/client.h"
#include "renderer/transport/checkpoint.h"

namespace command {

/// Settings of a run besides those of the render itself.
struct RunSettings {
  std::string checkpoint;                    ///< path; empty: none
  transport::Fingerprint fingerprint;        ///< of the checkpoint
  transport::Fingerprint image_fingerprint;  ///< of a part file
  std::optional<display::Address> display;
  display::ViewerLauncher
      viewer_launcher;  ///< starts an image viewer if none listens there; empty: starts none
  std::string title;    ///< of the displayed image
};

/// Runs a render to its end or until a signal: resumes it from its checkpoint, updates the checkpoint every
/// minute and at the end, and shows progress and the image. Returns false, with nothing rendered, if it
/// cannot resume from the checkpoint. A checkpoint that cannot be written, or a missing image viewer, is only
/// a warning.
bool run(transport::Render& render, SignalHandler& signal_handler, const RunSettings& settings,
         ProgressReport& progress, grf::Diagnostics& diagnostics);

/// Runs a bake likewise; there is no image to show.
bool run(bake::Bake& bake, SignalHandler& signal_handler, const RunSettings& settings,
         ProgressReport& progress, grf::Diagnostics& diagnostics);

/// Runs any work to its end or until a signal, and polls `watch` every 10 ms. Rethrows the work's exceptions.
template <class Work, class Watch>
void run_watched(Work& work, SignalHandler& signal_handler, const Watch& watch) {
  std::atomic<bool> ended = false;
  std::exception_ptr failure;
  signal_handler.stop_on_signal(work);
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
