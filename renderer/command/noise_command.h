#pragma once

#include <string>

#include "grf/exit_code.h"
#include "renderer/command/render_arguments.h"

namespace command {

/// The command line of `bpt noise`; flags are those of `bpt render`.
struct NoiseArguments {
  std::string scene;  ///< an OP file, or a GRF scene
  OptionFlags flags;
  bool tries = false;  ///< measures what other settings would do
  bool json = false;
};

/// Prints which lamps, bounces and BRDFs the noise of an image comes from, from eight independent images of
/// at most 16 samples per pixel and 192 pixels' width.
grf::ExitCode noise(const NoiseArguments& arguments);

}  // namespace command
