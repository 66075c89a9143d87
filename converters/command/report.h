#pragma once

#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "grf/diagnostics.h"
#include "grf/exit_code.h"

namespace convert {

using grf::ExitCode;

/// Prints to standard error; `quiet` leaves out warnings and notes.
void print(const grf::Diagnostics& diagnostics, bool quiet);

/// Prints one object to standard output. A path need not be UTF-8, and a string of JSON must: what is not is
/// replaced.
void print_json(const nlohmann::ordered_json& json);

/// Says what is wrong with the command line.
ExitCode bad_command_line(std::string_view message);

}  // namespace convert
