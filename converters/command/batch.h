#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "converters/command/convert.h"
#include "converters/command/supervisor.h"

namespace convert {

struct BatchOptions {
  std::vector<std::string> inputs;
  std::string output;    ///< a file, or a folder: see `is_folder_of_outputs`
  ConvertOptions each;   ///< but for the paths of input and output
  std::size_t jobs = 1;  ///< 0: as many as there are cores
  bool progress = false;
  Limits limits;
};

/// Whether outputs get names of their own: there are several inputs, or the output is a folder or ends in
/// `/`.
bool is_folder_of_outputs(const BatchOptions& options);

/// `grfconvert IN... -o OUT`: converts each file in a child process. One that fails does not keep the others
/// from being converted; the exit code says that it did, and so does a summary.
ExitCode convert_files(const BatchOptions& options);

}  // namespace convert
