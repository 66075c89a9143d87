#pragma once

#include <string>

#include "grf/exit_code.h"
#include "renderer/command/render_arguments.h"

namespace command {

/// The command line of `bpt noise`; flags are those of `bpt render`.
struct NoiseArguments {
  std::string scene;  ///< an OP file, or a GRF scene
  OptionFlags flags;
  bool tries = false;             ///< measures what other settings would do
  std::string change;             ///< only this one, see job::NoiseChange::word; empty: all
  std::string progress = "none";  ///< `json` prints a line per result
  bool json = false;
};

/// Prints which lamps, bounces and BRDFs the noise of an image comes from, from eight independent images of
/// at most 16 samples per pixel and 192 pixels' width, and what other settings would do.
grf::ExitCode noise(const NoiseArguments& arguments);

}  // namespace command
