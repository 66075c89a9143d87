#pragma once

#include "converters/command/input.h"
#include "converters/command/report.h"

namespace convert {

/// `grfconvert info`: the figures of a file, as a table or as one JSON object.
ExitCode print_info(const InputOptions& options, bool json, bool quiet);

}  // namespace convert
