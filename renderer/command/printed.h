#pragma once

#include <cstdio>

#include <fmt/format.h>

#include "grf/diagnostics.h"

namespace command {

/// Prints diagnostics to standard error.
inline void print(const grf::Diagnostics& diagnostics) { fmt::print(stderr, "{}", diagnostics.to_text()); }

/// Calls a function that takes diagnostics, prints these to standard error, and returns its result.
template <class Read>
auto printed(const Read& read) {
  grf::Diagnostics diagnostics;
  auto result = read(diagnostics);
  print(diagnostics);
  return result;
}

}  // namespace command
