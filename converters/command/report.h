#pragma once

#include <string_view>

#include "grf/diagnostics.h"
#include "grf/exit_code.h"

namespace convert {

using grf::ExitCode;

/// Prints to standard error; `quiet` leaves out warnings and notes.
void print(const grf::Diagnostics& diagnostics, bool quiet);

/// Says what is wrong with the command line.
ExitCode bad_command_line(std::string_view message);

}  // namespace convert
