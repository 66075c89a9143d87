#include "renderer/command/pack_command.h"

#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/text_file.h"
#include "renderer/command/json_values.h"
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

std::optional<Packable> packable_of(const PackArguments& arguments, const RenderOptions& render_options,
                                    Diagnostics& diagnostics) {
  Packable packable{fs::path(arguments.scene).replace_extension(".op").string(), {}};
  const bool has_file = packable.op_path == arguments.scene;
  if (has_file) {
    const auto text = grf::read_file(arguments.scene, diagnostics);
    if (!text) return std::nullopt;
    packable.text = options::OpText(*text);
  }
  for (const options::OptionInfo& option : options::option_table()) {
    const bool is_given = arguments.flags.contains(std::string(option.flag)) && !option.flag.empty();
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

ExitCode pack(const PackArguments& arguments) {
  Diagnostics diagnostics;
  const auto fail = [&] {
    fmt::print(stderr, "{}", diagnostics.to_text());
    return ExitCode::BadInput;
  };
  auto render_options = read_options(arguments.scene, diagnostics);
  if (!render_options) return fail();
  if (!apply_flags(arguments.flags, *render_options)) return ExitCode::BadCommandLine;
  const std::string output = arguments.output.empty()
                                 ? fs::path(arguments.scene).filename().replace_extension(".grfjob").string()
                                 : arguments.output;
  if (!is_job_file(output)) {
    fmt::print(stderr, "error: the name of a job file ends in .grfjob\n");
    return ExitCode::BadCommandLine;
  }
  if (!can_write_file(output, "job file", diagnostics)) return fail();
  const auto packable = packable_of(arguments, *render_options, diagnostics);
  if (!packable || !job::render_job(*render_options, diagnostics)) return fail();
  if (!job::pack_job(packable->op_path, packable->text, diagnostics.files(), output, diagnostics))
    return fail();
  if (Diagnostics of_packed; !is_complete(output, of_packed)) {
    for (const auto& entry : of_packed.entries()) diagnostics.error(entry.location, entry.message);
    diagnostics.error(grf::whole_file(output),
                      "the job file lacks a file that the scene names in an unusual way");
    return fail();
  }
  fmt::print(stderr, "{}", diagnostics.to_text());
  const nlohmann::ordered_json summary = {{"output", output}, {"bytes", fs::file_size(output)}};
  if (arguments.json) fmt::print("{}\n", json_text(summary, false));
  if (!arguments.json) fmt::print("{}: {} bytes\n", output, fs::file_size(output));
  return ExitCode::Done;
}

}  // namespace command
