#pragma once

#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "grf/diagnostics.h"
#include "grf/exit_code.h"

namespace convert {

using grf::ExitCode;

/// Prints diagnostics to standard error; `quiet` suppresses warnings and notes.
void print(const grf::Diagnostics& diagnostics, bool quiet);

/// Prints one object to standard output. Invalid UTF-8, which a path may have and JSON may not, is
/// replaced.
void print_json(const nlohmann::ordered_json& json);

/// Prints an error of the command line, and returns its exit code.
ExitCode bad_command_line(std::string_view message);

}  // namespace convert
