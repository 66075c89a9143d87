#pragma once

#include <string>
#include <vector>

#include "grf/exit_code.h"
#include "renderer/command/part_arguments.h"
#include "renderer/command/render_arguments.h"

namespace command {

/// The command line of `bpt render`.
struct RenderArguments {
  std::string scene;  ///< an OP file, or a GRF scene
  OptionFlags flags;
  PartFlags part;                    ///< a part file is written, unless they are empty
  std::vector<std::string> outputs;  ///< images to write, one per file type; empty: that of the OP file
  std::string progress = "bar";      ///< or `json`, or `none`
  bool json = false;
  bool forecasts = false;       ///< forecasts the cost of the render instead
  double forecast_seconds = 2;  ///< of the probe for that
};

/// Renders a scene, writes the image or a part of its samples, and prints a summary; or prints a forecast.
/// SIGINT and SIGTERM stop the render early; the image so far is written, but no part.
grf::ExitCode render(const RenderArguments& arguments);

}  // namespace command
