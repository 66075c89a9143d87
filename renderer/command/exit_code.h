#pragma once

namespace command {

/// What programs return.
enum class ExitCode { Done = 0, BadInput = 1, BadCommandLine = 2, Interrupted = 130 };

}  // namespace command
