#pragma once

#include <string>

#include "grf/exit_code.h"
#include "renderer/command/render_arguments.h"

namespace command {

/// The command line of `bpt bake`.
struct BakeArguments {
  std::string scene;  ///< an OP file, or a GRF scene
  std::string output;
  OptionFlags flags;
  int directions = 0;  ///< per vertex; 0: one irradiance value per vertex
  std::string progress = "bar";
  bool json = false;
};

/// Bakes the irradiance at the vertices of a scene and writes both as one IGRF file. SIGINT and SIGTERM stop
/// the bake early; the estimate so far is written.
grf::ExitCode bake(const BakeArguments& arguments);

}  // namespace command
