#include "tests/benchmarks/render/command_line.h"

#include <exception>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace benchmark {

int run_command_line(CLI::App& app, int argc, char** argv, const std::function<int()>& run) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    return run();
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 1;
  }
}

}  // namespace benchmark
