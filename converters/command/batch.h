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
  ConvertOptions each;   ///< options per file, except the paths of input and output
  std::size_t jobs = 1;  ///< number of parallel processes; 0: one per core
  bool progress = false;
  bool dry_run = false;  ///< write no file
  Limits limits;
};

/// Returns whether the output is a folder, in which each input gets a file: there are several inputs, or the
/// output is a folder or ends in `/`.
bool is_folder_of_outputs(const BatchOptions& options);

/// Runs `grfconvert IN... -o OUT`: converts each file in a child process, and continues after a failure,
/// which the exit code and a summary report.
ExitCode convert_files(const BatchOptions& options);

}  // namespace convert
