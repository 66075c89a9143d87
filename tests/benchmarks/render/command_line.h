// Programs that compare or measure renderers share how they parse their command lines and report errors.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace benchmark {

/// Parses the command line, and then calls `run`. Returns the exit code: that of `run`, 0 after `--help`, 2
/// if the command line is wrong, 1 if `run` throws; then the message is on standard error.
int run_command_line(CLI::App& app, int argc, char** argv, const std::function<int()>& run);

}  // namespace benchmark
