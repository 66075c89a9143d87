#pragma once

#include <string>
#include <vector>

#include "converters/command/report.h"
#include "converters/command/supervisor.h"

namespace convert {

/// `grfconvert check`: reads each file and says what is wrong with it, going on after one that is bad.
ExitCode check_files(const std::vector<std::string>& paths, bool json, bool quiet, const Limits& limits);

}  // namespace convert
