#include "converters/command/report.h"

#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

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

void print_json(const nlohmann::ordered_json& json) {
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  fmt::print("{}\n", json.dump(2, ' ', false, replace));
}

ExitCode bad_command_line(std::string_view message) {
  fmt::print(stderr, "grfconvert: {}\nRun with --help for more information.\n", message);
  return ExitCode::BadCommandLine;
}

}  // namespace convert
