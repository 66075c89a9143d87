#pragma once

#include <string>

#include "grf/exit_code.h"
#include "renderer/command/render_arguments.h"

namespace command {

/// The command line of `bpt plan`; flags are those of `bpt render`.
struct PlanArguments {
  std::string scene;  ///< an OP file, or a GRF scene
  OptionFlags flags;
  bool json = false;
};

/// Prints which effects a render would use, which it would leave out, and why. Builds all tables of sampling
/// schemes to report their size, also those that a render would leave out; reads no image.
grf::ExitCode plan(const PlanArguments& arguments);

}  // namespace command
