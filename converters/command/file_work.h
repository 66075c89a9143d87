#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "converters/command/report.h"
#include "converters/command/supervisor.h"

namespace convert {

/// What a command does with each of some files, each in a child process of its own.
struct FileWork {
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;  ///< one an input, or none at all if nothing is written
  std::size_t at_once = 1;
  Limits limits;

  std::function<ExitCode(std::size_t file)> work;  ///< in the child

  /// What became of a file.
  struct Result {
    std::size_t file = 0;
    ExitCode code = ExitCode::Done;
    bool has_ended = true;  ///< else it crashed, or broke a limit; the code is BadInput then
    std::string out;        ///< what the child printed on standard output; empty if it has not ended
  };
  /// Called here, in whatever order files are done, before anything of the file is printed.
  std::function<void(const Result& result)> before_errors = [](const Result&) {};
  /// Called afterwards: errors are printed by now, and what is left of a dead child is removed.
  std::function<void(const Result& result)> done;
};

/// Does the work. The code is that of the only file; of several, BadInput if one failed. Interrupted: a
/// signal came.
ExitCode run(const FileWork& work);

}  // namespace convert
