#include "renderer/command/pack_command.h"

#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/text_file.h"
#include "renderer/command/json_values.h"
#include "renderer/command/printed.h"
#include "renderer/command/render_output.h"
#include "renderer/job/job_file.h"
#include "renderer/job/render_job.h"

namespace command {
namespace {

namespace fs = std::filesystem;
using grf::Diagnostics;
using grf::ExitCode;
using options::RenderOptions;

/// The OP file that is packed: that of the command line, or one beside a GRF scene.
struct Packable {
  std::string op_path;
  options::OpText text;
};

std::optional<Packable> packable_of(const std::string& scene, const OptionFlags& flags,
                                    const RenderOptions& render_options, Diagnostics& diagnostics) {
  Packable packable{fs::path(scene).replace_extension(".op").string(), {}};
  const bool has_file = packable.op_path == scene;
  if (has_file) {
    const auto text = grf::read_file(scene, diagnostics);
    if (!text) return std::nullopt;
    packable.text = options::OpText(*text);
  }
  for (const options::OptionInfo& option : options::option_table()) {
    const bool is_given = flags.contains(std::string(option.flag)) && !option.flag.empty();
    const bool is_scene = option.key == "BPT_Scene" && !has_file;
    if (!is_given && !is_scene) continue;
    std::vector<std::string> words = option_words(render_options, option);
    // Paths of the command line are relative to the current folder, and those of the file to its own.
    if (std::holds_alternative<options::PathOption>(option.value) && words.size() == 1) {
      words = {fs::absolute(words.front()).string()};
    }
    packable.text.set(option, words);
  }
  return packable;
}

/// Reports an error if what was packed cannot be rendered without the original files.
bool is_complete(const std::string& job_file, Diagnostics& diagnostics) {
  UnpackedJob unpacked;
  const auto op_path = unpacked.unpack(job_file, diagnostics);
  if (!op_path) return false;
  const auto render_options = read_options(*op_path, diagnostics);
  return render_options && job::render_job(*render_options, diagnostics);
}

}  // namespace

bool is_job_file(const std::string& path) { return path.ends_with(".grfjob"); }

std::optional<std::string> UnpackedJob::unpack(const std::string& path, Diagnostics& diagnostics) try {
  folder_.emplace("grfjob");
  return job::unpack_job(path, folder_->path().string(), diagnostics);
} catch (const std::system_error&) {
  diagnostics.error(grf::whole_file(path), "cannot make a temporary folder to unpack it");
  return std::nullopt;
}

ExitCode pack_scene(const std::string& scene, const OptionFlags& flags, const std::string& output,
                    Diagnostics& diagnostics) {
  auto render_options = read_options(scene, diagnostics);
  if (!render_options) return ExitCode::BadInput;
  if (!apply_flags(flags, *render_options)) return ExitCode::BadCommandLine;
  if (!can_write_file(output, "job file", diagnostics)) return ExitCode::BadInput;
  const auto packable = packable_of(scene, flags, *render_options, diagnostics);
  const bool is_packed =
      packable && job::render_job(*render_options, diagnostics) &&
      job::pack_job(packable->op_path, packable->text, diagnostics.files(), output, diagnostics);
  return is_packed ? ExitCode::Done : ExitCode::BadInput;
}

ExitCode pack(const PackArguments& arguments) {
  const std::string output = arguments.output.empty()
                                 ? fs::path(arguments.scene).filename().replace_extension(".grfjob").string()
                                 : arguments.output;
  if (!is_job_file(output)) {
    fmt::print(stderr, "error: the name of a job file ends in .grfjob\n");
    return ExitCode::BadCommandLine;
  }
  Diagnostics diagnostics;
  ExitCode code = pack_scene(arguments.scene, arguments.flags, output, diagnostics);
  if (Diagnostics of_packed; code == ExitCode::Done && !is_complete(output, of_packed)) {
    for (const auto& entry : of_packed.entries()) diagnostics.error(entry.location, entry.message);
    diagnostics.error(grf::whole_file(output),
                      "the job file lacks a file that the scene names in an unusual way");
    code = ExitCode::BadInput;
  }
  print(diagnostics);
  if (code != ExitCode::Done) return code;
  const nlohmann::ordered_json summary = {{"output", output}, {"bytes", fs::file_size(output)}};
  if (arguments.json) fmt::print("{}\n", json_text(summary, false));
  if (!arguments.json) fmt::print("{}: {} bytes\n", output, fs::file_size(output));
  return ExitCode::Done;
}

}  // namespace command
