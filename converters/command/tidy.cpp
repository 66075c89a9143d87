#include "converters/command/tidy.h"

#include <cstdio>

#include <fmt/format.h>

#include "converters/command/file_work.h"
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

ExitCode tidy_file(const std::string& path, bool quiet) {
  grf::Diagnostics diagnostics;
  const Outcome outcome = tidy(path, diagnostics);
  print(diagnostics, quiet);
  if (outcome == Outcome::Failed) return ExitCode::BadInput;
  if (!quiet) fmt::print("{}: {}\n", path, outcome == Outcome::Tidied ? "tidied" : "already tidy");
  return ExitCode::Done;
}

}  // namespace

ExitCode tidy_files(const std::vector<std::string>& paths, bool quiet, const Limits& limits) {
  FileWork work;
  work.inputs = paths;
  work.outputs = paths;
  work.limits = limits;
  work.work = [&](std::size_t file) { return tidy_file(paths[file], quiet); };
  work.done = [](const FileWork::Result& result) { fmt::print("{}", result.out); };
  return run(work);
}

}  // namespace convert
