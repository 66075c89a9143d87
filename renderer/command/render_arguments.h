// Command-line flags override the render options of an OP file.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "renderer/command/render_progress.h"
#include "renderer/options/render_options.h"

namespace command {

/// Values by flag, such as `--samples`.
using OptionFlags = std::map<std::string, std::string>;

/// Reads an OP file; for a GRF file, returns default options for that scene. Nothing after an error.
std::optional<options::RenderOptions> read_options(const std::string& path, grf::Diagnostics& diagnostics);

/// Applies flags on top of the options of a file. Prints errors; returns false if there are any.
bool apply_flags(const OptionFlags& flags, options::RenderOptions& render_options);

/// Parses one of the words `bar`, `json` and `none`.
ProgressStyle progress_style_of(const std::string& word);

}  // namespace command
