// Several commands of bpt have these arguments.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "renderer/command/render_arguments.h"
#include "renderer/options/render_options.h"

namespace command {

/// Adds `--progress`.
void add_progress(CLI::App& command, std::string& progress);

/// Adds the flag of a render option.
void add_option(CLI::App& command, const options::OptionInfo& option, OptionFlags& flags);

/// Adds the scene argument, and all flags of the option table except `--output`.
void add_scene_options(CLI::App& command, std::string& scene, OptionFlags& flags);

}  // namespace command
