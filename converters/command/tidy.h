#pragma once

#include <string>
#include <vector>

#include "converters/command/report.h"
#include "converters/command/supervisor.h"

namespace convert {

/// Runs `grfconvert tidy`: reformats each GRF file that is not yet in the standard style, and continues after
/// one with errors. Models are not validated.
ExitCode tidy_files(const std::vector<std::string>& paths, bool quiet, const Limits& limits);

}  // namespace convert
