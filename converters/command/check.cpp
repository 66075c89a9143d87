#include "converters/command/check.h"

#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "converters/command/input.h"

namespace convert {

ExitCode check_files(const std::vector<std::string>& paths, bool json, bool quiet) {
  ExitCode code = ExitCode::Done;
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const std::string& path : paths) {
    grf::Diagnostics diagnostics;
    const bool sound = read_input({path, nullptr, {}}, diagnostics).has_value();
    if (!sound) code = ExitCode::BadInput;
    print(diagnostics, quiet);
    const std::size_t errors = diagnostics.error_count();
    const std::size_t warnings = diagnostics.warning_count();
    files.push_back({{"file", path}, {"errors", errors}, {"warnings", warnings}});
    if (!json && !quiet && sound) fmt::print("{}: sound{}\n", path, warnings > 0 ? ", with warnings" : "");
  }
  // A path need not be UTF-8, and a string of JSON must.
  const auto handler = nlohmann::ordered_json::error_handler_t::replace;
  if (json) fmt::print("{}\n", nlohmann::ordered_json{{"files", files}}.dump(2, ' ', false, handler));
  return code;
}

}  // namespace convert
