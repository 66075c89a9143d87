// A supervisor of child processes for jobs that may crash, hang or exhaust memory, since libraries parse
// untrusted bytes in them: each job runs in a child process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "grf/exit_code.h"

namespace convert {

/// Limits of one child. 0: no limit.
struct Limits {
  std::uint64_t memory = std::uint64_t(4) << 30U;  ///< bytes of address space; ignored under sanitizers
  double seconds = 600;                            ///< wall-clock time
  std::vector<std::string> readable;  ///< files and folders that a FileWork reads besides those of its files
};

/// The exit status and output of a child process.
struct ChildExit {
  enum class Cause {
    Returned,     ///< the job returned, successfully or not: see `code`
    OutOfMemory,  ///< an allocation failed, and only the child's `main` caught it
    OutOfTime,
    Crashed  ///< terminated by `signal`
  };
  Cause cause = Cause::Returned;
  grf::ExitCode code = grf::ExitCode::Done;  ///< the job's return value
  int signal = 0;
  std::string out;  ///< captured standard output; `err`: standard error
  std::string err;
  pid_t process = 0;
};

/// Jobs to run in child processes, identified by their index.
struct Jobs {
  std::size_t count = 0;
  std::size_t at_once = 1;  ///< maximum number of concurrent children

  /// Called in the child before its memory is limited, and before `work`.
  std::function<void(std::size_t job)> prepare = [](std::size_t) {};
  /// Called in the child. If it throws std::bad_alloc, the child ends as OutOfMemory; the message of any
  /// other exception is printed as an error, and the code is BadInput.
  std::function<grf::ExitCode(std::size_t job)> work;
  /// Called in this process as soon as a child has ended, in any order. May throw: the other children are
  /// terminated then.
  std::function<void(std::size_t job, const ChildExit& child_exit)> ended;
};

/// Runs all jobs, also after failures. Returns false after SIGINT or SIGTERM: all children were terminated
/// then, and `ended` was called only for those that had ended before. `left` gets the ids of the terminated
/// processes, which may have left temporary files.
///
/// Children leave no core dumps, and die with this process. This process must be single-threaded.
bool run_supervised(const Jobs& jobs, const Limits& limits, std::vector<pid_t>& left);

}  // namespace convert
