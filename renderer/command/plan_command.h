#pragma once

#include <string>

#include "grf/exit_code.h"
#include "renderer/command/render_arguments.h"

namespace command {

/// What `bpt plan` was told: as `bpt render`.
struct PlanArguments {
  std::string scene;  ///< an OP file, or a GRF scene
  OptionFlags flags;
  bool json = false;
};

/// Prints what a render would do, what it would leave out, and why. Builds the tables of sampling schemes,
/// also those that a render would not, to know their bytes; reads no image.
grf::ExitCode plan(const PlanArguments& arguments);

}  // namespace command
