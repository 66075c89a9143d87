#pragma once

#include <string>

#include "grf/exit_code.h"
#include "renderer/image/visible_difference.h"

namespace command {

/// The command line of `bpt compare`.
struct CompareArguments {
  std::string image;
  std::string reference;
  double exposure = 0;  ///< stops, with which the images are seen
  double pixels_per_degree = image::Viewing::DefaultPixelsPerDegree;
  bool json = false;
};

/// Prints the error metrics of an image against a reference of the same size, and the visible difference. A
/// large error is no failure.
grf::ExitCode compare(const CompareArguments& arguments);

}  // namespace command
