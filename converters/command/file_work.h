#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "converters/command/report.h"
#include "converters/command/supervisor.h"

namespace convert {

/// A command's work on several files, each in a child process of its own that reads only what is around its
/// input, and writes only into the folder of its output.
struct FileWork {
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;  ///< one per input, or empty if nothing is written
  /// Files that the work for any input writes besides, with others in their folders.
  std::vector<std::string> other_outputs;
  std::size_t at_once = 1;
  Limits limits;

  std::function<ExitCode(std::size_t file)> work;  ///< called in the child

  /// The result for a file.
  struct Result {
    std::size_t file = 0;
    ExitCode code = ExitCode::Done;
    bool has_ended = true;  ///< false: it crashed or exceeded a limit, and the code is BadInput
    std::string out;        ///< the child's standard output; empty unless it has ended
  };
  /// Called in this process as files complete, before the output of the file is printed.
  std::function<void(const Result& result)> before_errors = [](const Result&) {};
  /// Called afterwards: errors are printed by now, and temporary files of a dead child are removed.
  std::function<void(const Result& result)> done;
};

/// Runs the work. Returns the code of the only file, or BadInput if one of several failed; Interrupted after
/// a signal.
ExitCode run(const FileWork& work);

}  // namespace convert
