#pragma once

#include <string>
#include <vector>

#include "grf/exit_code.h"
#include "renderer/command/render_arguments.h"

namespace command {

/// What `bpt render` was told.
struct RenderArguments {
  std::string scene;  ///< an OP file, or a GRF scene
  OptionFlags flags;
  std::vector<std::string> outputs;  ///< images to write, of one type each; empty: what the file says
  std::string progress = "bar";      ///< or `json`, or `none`
  bool json = false;
};

/// Renders, writes the image and a summary. SIGINT and SIGTERM end it early with the image so far.
grf::ExitCode render(const RenderArguments& arguments);

}  // namespace command
