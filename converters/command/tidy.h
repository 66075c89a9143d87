#pragma once

#include <string>
#include <vector>

#include "converters/command/report.h"

namespace convert {

/// `grfconvert tidy`: writes each GRF file again in the one style, where it is not so yet, and goes on after
/// one that is bad. Models are not checked: a file is as good as it was.
ExitCode tidy_files(const std::vector<std::string>& paths, bool quiet);

}  // namespace convert
