#pragma once

namespace grf {

/// Exit codes of all programs of the project.
enum class ExitCode { Done = 0, BadInput = 1, BadCommandLine = 2, Interrupted = 130 };

}  // namespace grf
