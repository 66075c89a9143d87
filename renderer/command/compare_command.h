#pragma once

#include <string>

#include "grf/exit_code.h"

namespace command {

/// What `bpt compare` was told.
struct CompareArguments {
  std::string image;
  std::string reference;
  bool json = false;
};

/// Prints how far an image is from a reference of the same size. Images that differ are no error.
grf::ExitCode compare(const CompareArguments& arguments);

}  // namespace command
