#pragma once

#include <string>
#include <vector>

#include "converters/command/report.h"
#include "converters/command/supervisor.h"

namespace convert {

struct CheckOptions {
  bool deep = false;  ///< lists risks, too: see `risks_of`
  bool json = false;
  bool quiet = false;
};

/// Runs `grfconvert check`: validates each file, and continues after one with errors. Risks are no errors.
ExitCode check_files(const std::vector<std::string>& paths, const CheckOptions& options,
                     const Limits& limits);

}  // namespace convert
