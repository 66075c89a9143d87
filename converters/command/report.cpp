#include "converters/command/report.h"

#include <cstdio>

#include <fmt/format.h>

namespace convert {

void print(const grf::Diagnostics& diagnostics, bool quiet) {
  if (!quiet) {
    fmt::print(stderr, "{}", diagnostics.to_text());
    return;
  }
  for (const grf::Diagnostic& entry : diagnostics.entries()) {
    if (entry.severity == grf::Severity::Error) fmt::print(stderr, "{}", grf::to_text(entry));
  }
}

ExitCode bad_command_line(std::string_view message) {
  fmt::print(stderr, "grfconvert: {}\nRun with --help for more information.\n", message);
  return ExitCode::BadCommandLine;
}

}  // namespace convert
