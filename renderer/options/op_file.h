#pragma once

#include <memory>
#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "renderer/options/render_options.h"

namespace options {

/// Reads an OP file: a key and its values per line, `#` and `//` for comments. Paths are taken relative to
/// the folder of the file. Reports all errors in the diagnostics and then returns nothing.
std::optional<RenderOptions> read_op_file(const std::string& path, grf::Diagnostics& diagnostics);

/// Parses the text of an OP file likewise; `path` need not exist.
std::optional<RenderOptions> read_op_text(const std::string& path, std::shared_ptr<const std::string> text,
                                          grf::Diagnostics& diagnostics);

}  // namespace options
