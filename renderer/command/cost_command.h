#pragma once

#include <string>
#include <vector>

#include "grf/exit_code.h"
#include "renderer/command/cost_lines.h"
#include "renderer/command/render_arguments.h"

namespace command {

/// The command line of `bpt cost`.
struct CostArguments {
  std::string scene;  ///< an OP file, or a GRF scene
  OptionFlags flags;  ///< that all renders have in common
  Sweeps sweeps;
  std::string samples = "4,16,64,256";
  std::string reference;      ///< path of an image; empty: the reference is rendered
  int reference_samples = 0;  ///< samples per pixel; 0: 16 times the most of the sweep
  int rounds = 2;
  std::vector<int> crop;               ///< x, y, width and height in pixels; empty: the whole image
  std::string part;                    ///< such as 2/8: the lines that this machine measures; empty: all
  std::vector<std::string> continued;  ///< BASE.json of earlier studies, or of the parts of one
  std::string output;                  ///< BASE; empty: the scene's name with -cost
  std::string progress = "bar";        ///< or `json`, or `none`
  bool json = false;
};

/// Measures error against render time over a sweep of sample counts and settings, and writes a table, a chart
/// and fitted curves. SIGINT and SIGTERM stop it early; the rows so far are written.
grf::ExitCode cost(const CostArguments& arguments);

}  // namespace command
