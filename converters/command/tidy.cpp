#include "converters/command/tidy.h"

#include <cstdio>

#include <fmt/format.h>

#include "converters/format.h"
#include "grf/read.h"
#include "grf/text_file.h"
#include "grf/write.h"

namespace convert {
namespace {

enum class Outcome { Tidied, WasTidy, Failed };

Outcome tidy(const std::string& path, grf::Diagnostics& diagnostics) {
  const Format* format = recognise(path, diagnostics);
  if (format == nullptr) return Outcome::Failed;
  if (format->name != "grf") {
    diagnostics.error(grf::whole_file(path), fmt::format("this is {}, expected GRF", format->name));
    return Outcome::Failed;
  }
  const auto scene = grf::read(path, diagnostics);
  if (!scene) return Outcome::Failed;
  const auto old_text = grf::read_file(path, diagnostics);
  if (old_text && *old_text == grf::to_text(*scene)) return Outcome::WasTidy;
  return grf::write(*scene, path, diagnostics) ? Outcome::Tidied : Outcome::Failed;
}

}  // namespace

ExitCode tidy_files(const std::vector<std::string>& paths, bool quiet) {
  ExitCode code = ExitCode::Done;
  for (const std::string& path : paths) {
    grf::Diagnostics diagnostics;
    const Outcome outcome = tidy(path, diagnostics);
    print(diagnostics, quiet);
    if (outcome == Outcome::Failed) {
      code = ExitCode::BadInput;
    } else if (!quiet) {
      fmt::print("{}: {}\n", path, outcome == Outcome::Tidied ? "tidied" : "already tidy");
    }
  }
  return code;
}

}  // namespace convert
