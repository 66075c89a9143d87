#pragma once

#include <string>
#include <vector>

#include "converters/command/report.h"
#include "converters/command/supervisor.h"

namespace convert {

/// Runs `grfconvert check`: validates each file, and continues after one with errors.
ExitCode check_files(const std::vector<std::string>& paths, bool json, bool quiet, const Limits& limits);

}  // namespace convert
