#pragma once

namespace grf {

/// What every program of the project returns.
enum class ExitCode { Done = 0, BadInput = 1, BadCommandLine = 2, Interrupted = 130 };

}  // namespace grf
