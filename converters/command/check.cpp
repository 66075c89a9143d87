#include "converters/command/check.h"

#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "converters/command/file_work.h"
#include "converters/command/input.h"

namespace convert {
namespace {

nlohmann::ordered_json entry_of(const std::string& path, std::size_t errors, std::size_t warnings) {
  return {{"file", path}, {"errors", errors}, {"warnings", warnings}};
}

ExitCode check_file(const std::string& path, bool json, bool quiet) {
  grf::Diagnostics diagnostics;
  const bool sound = read_input({path, nullptr, {}}, diagnostics).has_value();
  print(diagnostics, quiet);
  const std::size_t warnings = diagnostics.warning_count();
  if (json) print_json(entry_of(path, diagnostics.error_count(), warnings));
  if (!json && !quiet && sound) fmt::print("{}: valid{}\n", path, warnings > 0 ? ", with warnings" : "");
  return sound ? ExitCode::Done : ExitCode::BadInput;
}

}  // namespace

ExitCode check_files(const std::vector<std::string>& paths, bool json, bool quiet, const Limits& limits) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  FileWork work;
  work.inputs = paths;
  work.limits = limits;
  work.work = [&](std::size_t file) { return check_file(paths[file], json, quiet); };
  work.done = [&](const FileWork::Result& result) {
    if (!json) {
      fmt::print("{}", result.out);
    } else if (result.out.empty()) {
      files.push_back(entry_of(paths[result.file], 1, 0));
    } else {
      files.push_back(nlohmann::ordered_json::parse(result.out));
    }
  };
  const ExitCode code = run(work);
  if (json && code != ExitCode::Interrupted) print_json({{"files", files}});
  return code;
}

}  // namespace convert
