// The command line of `bpt farm`.
#pragma once

#include <CLI/CLI.hpp>

#include "grf/exit_code.h"
#include "renderer/command/farm_command.h"

namespace command {

/// The arguments of `bpt farm` and its commands.
class FarmCommandLine {
 public:
  /// Adds the commands to those of bpt.
  explicit FarmCommandLine(CLI::App& app);
  FarmCommandLine(const FarmCommandLine&) = delete;  // CLI11 keeps the addresses of the members
  FarmCommandLine& operator=(const FarmCommandLine&) = delete;

  /// Runs the command that was given.
  grf::ExitCode run() const;

 private:
  void add_serve();
  void add_work();
  void add_render();
  void add_others();

  CLI::App& farm_;
  FarmServeArguments serve_;
  FarmWorkArguments work_;
  FarmRenderArguments render_;
  FarmArguments other_;
  std::string job_;
};

}  // namespace command
