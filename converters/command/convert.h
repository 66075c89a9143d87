#pragma once

#include <string>

#include "converters/command/input.h"
#include "converters/command/report.h"

namespace convert {

struct ConvertOptions {
  InputOptions input;
  std::string output;
  const Format* output_format = nullptr;  ///< null: told by the output's name
  bool flat = false;                      ///< includes and BRDF files are written out in the one file
  bool grf2008 = false;                   ///< the grammar of 2008 alone
  bool quiet = false;
};

/// `grfconvert IN -o OUT`: nothing is written unless all of the input could be read.
ExitCode convert_file(const ConvertOptions& options);

}  // namespace convert
