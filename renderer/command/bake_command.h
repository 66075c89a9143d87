#pragma once

#include <string>

#include "grf/exit_code.h"
#include "renderer/command/render_arguments.h"

namespace command {

/// What `bpt bake` was told.
struct BakeArguments {
  std::string scene;  ///< an OP file, or a GRF scene
  std::string output;
  OptionFlags flags;
  int directions = 0;  ///< 0: one value a vertex
  std::string progress = "bar";
  bool json = false;
};

/// Estimates the irradiance at the vertices of a scene and writes both as one IGRF file. SIGINT and SIGTERM
/// end it early with what there is.
grf::ExitCode bake(const BakeArguments& arguments);

}  // namespace command
