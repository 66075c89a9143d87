#pragma once

#include "converters/command/report.h"
#include "converters/command/supervisor.h"
#include "converters/input.h"

namespace convert {

/// Runs `grfconvert info`: prints statistics of a file as a table or as one JSON object.
ExitCode print_info(const InputOptions& options, bool json, bool quiet, const Limits& limits);

}  // namespace convert
