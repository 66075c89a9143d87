#pragma once

#include <string>

#include "grf/exit_code.h"
#include "renderer/command/cost_lines.h"
#include "renderer/command/render_arguments.h"

namespace command {

/// What `bpt cost` was told.
struct CostArguments {
  std::string scene;  ///< an OP file, or a GRF scene
  OptionFlags flags;  ///< of all renders
  Sweeps sweeps;
  std::string samples = "4,16,64,256";
  std::string reference;      ///< path of an image; empty: it is rendered
  int reference_samples = 0;  ///< 0: 16 times the most samples of the sweep
  int rounds = 2;
  std::string output;            ///< BASE; empty: the scene's name with -cost
  std::string progress = "bar";  ///< or `json`, or `none`
  bool json = false;
};

/// Renders a scene over and over, and writes what accuracy costs: a table, a picture and the fitted curves.
/// SIGINT and SIGTERM end it early with the rows so far.
grf::ExitCode cost(const CostArguments& arguments);

}  // namespace command
