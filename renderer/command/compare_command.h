#pragma once

#include <string>

#include "grf/exit_code.h"

namespace command {

/// The command line of `bpt compare`.
struct CompareArguments {
  std::string image;
  std::string reference;
  bool json = false;
};

/// Prints the error metrics of an image against a reference of the same size. A large error is no failure.
grf::ExitCode compare(const CompareArguments& arguments);

}  // namespace command
