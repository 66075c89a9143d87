#include "converters/command/batch.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "confinement/confinement.h"
#include "converters/command/file_work.h"
#include "converters/command/progress.h"
#include "converters/wording.h"
#include "grf/short_lived_folder.h"
#include "grf/text_file.h"

namespace convert {
namespace {

/// Returns the path of an output in the folder, with the format's extension; `.igrf` stays.
std::string name_in_folder(const std::string& folder, const std::string& input, const Format& format) {
  const std::filesystem::path path(input);
  const bool is_igrf = format.name == "grf" && grf::is_igrf_name(input);
  const std::string_view extension = is_igrf ? "igrf" : format.extensions.front();
  return (std::filesystem::path(folder) / path.stem()).string() + fmt::format(".{}", extension);
}

/// Returns whether the path is an existing file, or does not exist and has the extension of a format.
bool looks_like_a_file(const std::string& path) {
  std::error_code error;
  if (std::filesystem::exists(path, error)) return !std::filesystem::is_directory(path, error);
  return !path.ends_with('/') && format_of_name(path) != nullptr;
}

/// Lists all conversions; empty after an error, with the reason in `problem`.
std::vector<ConvertOptions> conversions_of(const BatchOptions& options, std::string& problem) {
  const bool has_folder = is_folder_of_outputs(options);
  if (has_folder && looks_like_a_file(options.output)) {
    problem = fmt::format("several files need an output folder, and '{}' is a file", options.output);
  }
  std::vector<ConvertOptions> conversions;
  std::map<std::string, std::string> input_of;  // by output
  for (const std::string& input : options.inputs) {
    ConvertOptions conversion = options.each;
    conversion.input.path = input;
    conversion.output = options.output;
    if (has_folder && conversion.output_format == nullptr) conversion.output_format = find_format("grf");
    if (has_folder) conversion.output = name_in_folder(options.output, input, *conversion.output_format);
    if (problem.empty()) problem = problem_of(conversion);
    const auto [other, is_new] = input_of.emplace(grf::canonical_path(conversion.output), input);
    if (!is_new && problem.empty()) {
      problem =
          fmt::format("'{}' and '{}' would both be written to '{}'", other->second, input, conversion.output);
    }
    if (!problem.empty()) return {};
    conversions.push_back(std::move(conversion));
  }
  return conversions;
}

bool make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (!error) return true;
  grf::Diagnostics diagnostics;
  diagnostics.error(grf::whole_file(path), fmt::format("cannot create the folder: {}", error.message()));
  print(diagnostics, true);
  return false;
}

/// Prints the results of the conversions.
class Report {
 public:
  explicit Report(const BatchOptions& options)
      : options_(options),
        results_(options.inputs.size()),
        progress_(options.inputs.size(), options.progress && !options.each.quiet) {}

  void clear() const { progress_.clear(); }

  void add(const FileWork::Result& result) {
    const std::string& input = options_.inputs[result.file];
    const bool is_converted = result.code == ExitCode::Done;
    if (!is_converted) failed_.push_back(input);
    if (is_batch() && options_.each.json) {
      if (is_converted) results_[result.file] = nlohmann::ordered_json::parse(result.out);
    } else {
      fmt::print("{}", result.out);
      std::fflush(stdout);
    }
    progress_.add(input, is_converted);
  }

  void finish() const {
    progress_.clear();
    if (!is_batch()) return;
    if (options_.each.json) {
      nlohmann::ordered_json conversions = nlohmann::ordered_json::array();
      for (const auto& result : results_) {
        if (!result.is_null()) conversions.push_back(result);
      }
      print_json({{"conversions", conversions}, {"failed", failed_}});
    } else if (!options_.each.quiet) {
      const std::size_t count = options_.inputs.size();
      fmt::print("{} of {} files {}{}\n", count - failed_.size(), count,
                 options_.dry_run ? "can be converted (not written: --dry-run)" : "converted",
                 failed_.empty() ? "" : fmt::format("; failed: {}", listed(failed_)));
    }
  }

 private:
  bool is_batch() const { return options_.inputs.size() > 1; }

  const BatchOptions& options_;
  std::vector<nlohmann::ordered_json> results_;  // by file; null if it failed
  std::vector<std::string> failed_;
  Progress progress_;
};

}  // namespace

bool is_folder_of_outputs(const BatchOptions& options) {
  std::error_code error;
  return options.inputs.size() > 1 || options.output.ends_with('/') ||
         std::filesystem::is_directory(options.output, error);
}

ExitCode convert_files(const BatchOptions& options) {
  std::string problem;
  std::vector<ConvertOptions> conversions = conversions_of(options, problem);
  if (!problem.empty()) return bad_command_line(problem);
  const bool needs_folder = is_folder_of_outputs(options) && !options.dry_run;
  if (needs_folder && !make_folder(options.output)) return ExitCode::BadInput;

  Report report(options);
  FileWork work;
  work.inputs = options.inputs;
  work.at_once = options.jobs > 0 ? options.jobs : std::max(std::thread::hardware_concurrency(), 1U);
  work.limits = options.limits;
  if (!options.each.writing.op_file.empty()) {
    for (std::string& path : confinement::paths_around(options.each.writing.op_file))
      work.limits.readable.push_back(std::move(path));
  }
  const bool has_report = !options.each.report.empty();
  std::optional<grf::ShortLivedFolder> folder;
  if (options.dry_run || has_report) folder.emplace("grfconvert");
  for (ConvertOptions& conversion : conversions) {
    if (options.dry_run) conversion.dry_run_folder = folder->path().string();
    if (has_report) conversion.report_folder = folder->path().string();
    work.outputs.push_back(written_path(conversion));
  }
  if (has_report) work.other_outputs = {options.each.report, (folder->path() / "scene.grf").string()};
  work.work = [&](std::size_t file) { return convert_file(conversions[file]); };
  work.before_errors = [&](const FileWork::Result&) { report.clear(); };
  work.done = [&](const FileWork::Result& result) { report.add(result); };
  const ExitCode code = run(work);
  if (code != ExitCode::Interrupted) report.finish();
  return code;
}

}  // namespace convert
