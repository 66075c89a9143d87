#pragma once

#include <string>

#include "grf/exit_code.h"
#include "renderer/command/merge_command.h"
#include "renderer/command/part_arguments.h"
#include "renderer/command/render_arguments.h"

namespace command {

/// The command line of `bpt bake`.
struct BakeArguments {
  std::string scene;   ///< an OP file, or a GRF scene
  std::string output;  ///< an IGRF file, or a part file
  OptionFlags flags;
  int directions = 0;  ///< per vertex; 0: one irradiance value per vertex
  PartFlags part;      ///< `part` and `pilot`
  std::string progress = "bar";
  bool json = false;
};

/// Bakes the irradiance at the vertices of a scene and writes both as one IGRF file. SIGINT and SIGTERM stop
/// the bake early; the estimate so far is written. A part of it is written as a part file, once it is done.
grf::ExitCode bake(const BakeArguments& arguments);

/// Merges part files of a bake, in any order, to its IGRF file or to a larger part file, or prints the parts
/// that lack.
grf::ExitCode merge_bake(const MergeArguments& arguments);

}  // namespace command
