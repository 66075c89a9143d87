// Work that may crash, hang or want too much memory, since libraries parse untrusted bytes in it: each piece
// is done in a child process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "grf/exit_code.h"

namespace convert {

/// What one child may use. 0: as much as there is.
struct Limits {
  std::uint64_t memory = std::uint64_t(4) << 30U;  ///< bytes of address space; not heeded under sanitizers
  double seconds = 600;                            ///< by the clock on the wall
};

/// How a child ended.
struct Ending {
  enum class Cause {
    Returned,     ///< the work was done, well or not: see `code`
    OutOfMemory,  ///< an allocation failed, and nobody but the child's `main` knew what to do
    OutOfTime,
    Crashed  ///< by `signal`
  };
  Cause cause = Cause::Returned;
  grf::ExitCode code = grf::ExitCode::Done;  ///< what the work returned
  int signal = 0;
  std::string out;  ///< all that was printed on standard output and standard error
  std::string err;
  pid_t process = 0;
};

/// Work of several pieces, of which each has an index.
struct Pieces {
  std::size_t count = 0;
  std::size_t at_once = 1;  ///< so many children there are at most

  /// Done in the child. An exception is what the work has no answer to: of std::bad_alloc the ending is
  /// OutOfMemory, what another one says is printed as an error, and the code is BadInput.
  std::function<grf::ExitCode(std::size_t piece)> work;
  /// Called in this process as soon as a child has ended, in whatever order they do. May throw: the others
  /// are ended then.
  std::function<void(std::size_t piece, const Ending& ending)> ended;
};

/// Does all pieces, whatever becomes of each. False: SIGINT or SIGTERM came; all children were ended then,
/// and `ended` was called for those alone that had ended before. `left` gets the processes that were ended
/// so, since there may be temporary files of theirs.
///
/// Children leave no core dumps, and die with this process. This process must have one thread alone.
bool run_supervised(const Pieces& pieces, const Limits& limits, std::vector<pid_t>& left);

}  // namespace convert
