#include "converters/command/check.h"

#include <cstdio>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "converters/command/file_work.h"
#include "converters/input.h"
#include "converters/risks/risk.h"
#include "converters/wording.h"
#include "renderer/reflectance/scheme.h"

namespace convert {
namespace {

nlohmann::ordered_json entry_of(const std::string& path, std::size_t errors, std::size_t warnings) {
  return {{"file", path}, {"errors", errors}, {"warnings", warnings}};
}

nlohmann::ordered_json entry_of(const Risk& risk) {
  nlohmann::ordered_json entry = {{"kind", info_of(risk.kind).name},
                                  {"message", risk.message},
                                  {"advice", info_of(risk.kind).advice},
                                  {"share", risk.share},
                                  {"faces", risk.faces}};
  if (risk.location.line > 0) entry.update({{"line", risk.location.line}, {"column", risk.location.column}});
  return entry;
}

void print_risk(std::size_t rank, const Risk& risk) {
  std::string place;
  if (risk.location.line > 0) place = fmt::format(" (line {})", risk.location.line);
  std::string faces;
  if (!risk.faces.empty()) faces = fmt::format("; the first is face {}", risk.faces.front());
  fmt::print("  {}. {}{}{}\n     {}\n", rank, risk.message, place, faces, info_of(risk.kind).advice);
}

ExitCode check_file(const std::string& path, const CheckOptions& options) {
  grf::Diagnostics diagnostics;
  const std::optional<Input> input = read_input({path, nullptr, {}}, diagnostics);
  print(diagnostics, options.quiet);
  std::vector<Risk> risks;
  if (input && options.deep) risks = risks_of(input->import.scene, reflectance::catalogue());
  if (options.json) {
    nlohmann::ordered_json entry = entry_of(path, diagnostics.error_count(), diagnostics.warning_count());
    if (options.deep) {
      entry["risks"] = nlohmann::ordered_json::array();
      for (const Risk& risk : risks) entry["risks"].push_back(entry_of(risk));
    }
    print_json(entry);
  } else if (input && !options.quiet) {
    fmt::print("{}: valid{}{}\n", path, diagnostics.warning_count() > 0 ? ", with warnings" : "",
               options.deep ? fmt::format(", {}", counted(risks.size(), "risk", "risks")) : "");
    for (std::size_t i = 0; i < risks.size(); ++i) print_risk(i + 1, risks[i]);
  }
  return input ? ExitCode::Done : ExitCode::BadInput;
}

}  // namespace

ExitCode check_files(const std::vector<std::string>& paths, const CheckOptions& options,
                     const Limits& limits) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  FileWork work;
  work.inputs = paths;
  work.limits = limits;
  work.work = [&](std::size_t file) { return check_file(paths[file], options); };
  work.done = [&](const FileWork::Result& result) {
    if (!options.json) {
      fmt::print("{}", result.out);
    } else if (result.out.empty()) {
      files.push_back(entry_of(paths[result.file], 1, 0));
    } else {
      files.push_back(nlohmann::ordered_json::parse(result.out));
    }
  };
  const ExitCode code = run(work);
  if (options.json && code != ExitCode::Interrupted) print_json({{"files", files}});
  return code;
}

}  // namespace convert
