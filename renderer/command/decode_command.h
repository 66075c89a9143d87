#pragma once

#include <string>

#include "grf/exit_code.h"

namespace command {

/// The command line of `bpt decode`.
struct DecodeArguments {
  std::string image;
  bool has_layers = false;
  bool has_alpha = false;  ///< writes alpha, if the image has it, as a layer `A`
};

/// Decodes an image for programs that leave untrusted images to a separate process. It confines the process
/// to this image and the standard streams. Errors do not name the file.
grf::ExitCode decode(const DecodeArguments& arguments);

}  // namespace command
