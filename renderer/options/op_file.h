#pragma once

#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "renderer/options/render_options.h"

namespace options {

/// Reads an OP file: a key and its values on each line, `#` and `//` for comments. Paths become relative to
/// the folder of the file. If anything is wrong, all of it is in the diagnostics and nothing is returned.
std::optional<RenderOptions> read_op_file(const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace options
