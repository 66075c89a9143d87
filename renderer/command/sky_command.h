#pragma once

#include <string>

#include "grf/exit_code.h"

namespace command {

/// The command line of `bpt sky`.
struct SkyArguments {
  double latitude = 0;   ///< degrees
  double longitude = 0;  ///< degrees
  std::string date;      ///< YYYY-MM-DD
  std::string time;      ///< HH:MM
  double utc_offset = 0;
  double turbidity = 3;
  double north = 0;
  int width = 1024;
  std::string output;
  bool json = false;
};

/// Writes an environment map of the sky and the sun at a place and a time, and prints what it shows.
grf::ExitCode sky(const SkyArguments& arguments);

}  // namespace command
