// How the words of a command line become the options of a render or of a bake.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "renderer/command/render_progress.h"
#include "renderer/options/render_options.h"

namespace command {

/// Options of the table by their flags, as `--samples`.
using OptionFlags = std::map<std::string, std::string>;

/// What an OP file says; a GRF file says which scene alone. Nothing after an error.
std::optional<options::RenderOptions> read_options(const std::string& path, grf::Diagnostics& diagnostics);

/// Sets what flags say, over what a file says. Prints what is wrong; false if anything is.
bool apply_flags(const OptionFlags& flags, options::RenderOptions& render_options);

/// Of the words `bar`, `json` and `none`.
ProgressStyle progress_style_of(const std::string& word);

}  // namespace command
