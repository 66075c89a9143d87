#pragma once

#include <string>
#include <vector>

#include "grf/exit_code.h"

namespace command {

/// The command line of `bpt merge`.
struct MergeArguments {
  std::vector<std::string> parts;    ///< files
  std::vector<std::string> outputs;  ///< images, or one part file
  bool lists_missing = false;        ///< prints which samples lack instead
  bool json = false;
};

/// Merges parts of an image to the image, or to a larger part, and prints a summary. An image of which
/// samples lack is not written.
grf::ExitCode merge(const MergeArguments& arguments);

}  // namespace command
