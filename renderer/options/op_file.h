#pragma once

#include <memory>
#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "renderer/options/render_options.h"

namespace options {

/// Reads an OP file: a key and its values on each line, `#` and `//` for comments. Paths become relative to
/// the folder of the file. If anything is wrong, all of it is in the diagnostics and nothing is returned.
std::optional<RenderOptions> read_op_file(const std::string& path, grf::Diagnostics& diagnostics);

/// The same of a text that the file has, or would have.
std::optional<RenderOptions> read_op_text(const std::string& path, std::shared_ptr<const std::string> text,
                                          grf::Diagnostics& diagnostics);

}  // namespace options
