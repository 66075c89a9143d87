#include "converters/command/convert.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "converters/command/conversion_report.h"
#include "converters/mesh_operations/scene_placement.h"
#include "converters/output.h"
#include "converters/scene_building.h"
#include "converters/wording.h"
#include "grf/relocate.h"
#include "grf/text_file.h"
#include "grf/visit.h"
#include "renderer/image/image.h"
#include "renderer/options/op_file.h"
#include "renderer/options/op_text.h"

namespace convert {
namespace {

/// Returns the names of the formats that have a function, such as one that writes.
template <class Function>
std::string formats_with(Function Format::*function) {
  std::string names;
  for (const Format& format : formats()) {
    if (format.*function != nullptr) names += fmt::format("{}{}", names.empty() ? "" : ", ", format.name);
  }
  return names;
}

bool is_dry_run(const ConvertOptions& options) { return !options.dry_run_folder.empty(); }

bool is_same_file(const std::string& a, const std::string& b) {
  return grf::canonical_path(a) == grf::canonical_path(b);
}

bool has_includes(const grf::BlockList& list) {
  return std::any_of(list.blocks.begin(), list.blocks.end(), [](const grf::Block& block) {
    if (const auto* transform = std::get_if<grf::Transform>(&block.content))
      return has_includes(transform->body);
    if (const auto* scope = std::get_if<grf::DefinitionScope>(&block.content))
      return has_includes(scope->body);
    return std::holds_alternative<grf::Include>(block.content);
  });
}

/// Leaves out all other meshes than those of the names.
void keep_only(const std::vector<std::string>& names, grf::Scene& scene, const grf::SourceLocation& location,
               grf::Diagnostics& diagnostics) {
  std::set<std::string> found;
  keep_meshes(scene.contents, [&](const grf::Mesh& mesh) {
    const bool is_kept = std::find(names.begin(), names.end(), mesh.name) != names.end();
    if (is_kept) found.insert(mesh.name);
    return is_kept;
  });
  for (const std::string& name : names) {
    if (!found.contains(name)) diagnostics.error(location, fmt::format("no mesh is called '{}'", name));
  }
}

/// Applies the options to the scene; file names stay relative to the input.
grf::Scene changed(Import import, const ConvertOptions& options, grf::Diagnostics& diagnostics) {
  const std::string& path = options.input.path;
  grf::Scene scene = std::move(import.scene);
  // Writers of other formats would report the loss of names that the input does not have.
  if (!import.is_grf && output_format(options)->name == "grf") name_meshes(scene, path);
  const grf::SourceLocation location = grf::whole_file(path);
  if (!options.only.empty()) keep_only(options.only, scene, location, diagnostics);
  // Meshes of included files are in other files, which must not change.
  const bool joins_files = options.operations.any() && !options.flat && has_includes(scene.contents);
  if (joins_files) diagnostics.note(location, "meshes are changed: all files are written as one");
  if (options.flat || joins_files) scene = grf::flatten(scene, path);
  apply(options.operations, scene, location, diagnostics);
  place(scene, options.placement, location);
  return scene;
}

/// Writes the scene with the embedded files of the input; returns nothing after an error.
std::optional<WrittenFiles> write_all(grf::Scene& scene, const std::vector<EmbeddedFile>& embedded,
                                      const ConvertOptions& options, grf::Diagnostics& diagnostics) {
  return write_output(scene, embedded, options.input.path,
                      {options.output, output_format(options), options.writing, options.grf2008},
                      diagnostics);
}

/// Copies the diagnostics of one file to another file.
void say_of(const std::string& path, const grf::Diagnostics& said, grf::Diagnostics& diagnostics) {
  const grf::SourceLocation location = grf::whole_file(path);
  for (const grf::Diagnostic& entry : said.entries()) {
    const auto& losses = said.losses();
    if (entry.severity == grf::Severity::Error) {
      diagnostics.error(location, entry.message);
    } else if (entry.severity == grf::Severity::Note) {
      diagnostics.note(location, entry.message);
    } else if (std::find(losses.begin(), losses.end(), entry.message) != losses.end()) {
      diagnostics.loss(location, entry.message);
    } else {
      diagnostics.warning(location, entry.message);
    }
  }
}

/// Writes to the folder of a dry run to get the diagnostics of writing.
std::optional<WrittenFiles> try_to_write_all(grf::Scene& scene, const std::vector<EmbeddedFile>& embedded,
                                             const ConvertOptions& options, grf::Diagnostics& diagnostics) {
  ConvertOptions elsewhere = options;
  elsewhere.output_format = output_format(options);
  elsewhere.output = written_path(options);
  grf::Diagnostics said;
  const auto written = write_all(scene, embedded, elsewhere, said);
  say_of(options.output, said, diagnostics);
  return written ? std::optional(WrittenFiles()) : std::nullopt;
}

/// Replaces an OP file as the input by the scene that it names; nothing after an error.
std::optional<ConvertOptions> with_scene_of_op_file(ConvertOptions options, grf::Diagnostics& diagnostics) {
  if (!is_op_file(options.input.path)) return options;
  const auto view = options::read_op_file(options.input.path, diagnostics);
  if (!view) return std::nullopt;
  if (view->scene.empty()) {
    diagnostics.error(grf::whole_file(options.input.path), "it names no scene (BPT_Scene)");
    return std::nullopt;
  }
  if (options.writing.op_file.empty()) options.writing.op_file = options.input.path;
  options.input.path = view->scene;
  return options;
}

/// Writes an OP file that renders a scene, with its cameras: the first one renders.
bool write_op_file(const std::string& path, const std::string& scene,
                   const std::vector<options::NamedCamera>& cameras, grf::Diagnostics& diagnostics) {
  options::RenderOptions view;
  view.scene = std::filesystem::path(scene).filename().string();
  view.cameras = cameras;
  if (!cameras.empty()) view.camera = cameras.front().name;
  options::OpText text;
  for (const options::OptionInfo& option : options::option_table()) {
    const std::vector<std::string> words = option_words(view, option);
    if (words == option_words({}, option) || text.set(option, words)) continue;
    diagnostics.error(grf::whole_file(path),
                      fmt::format("{}: cannot write '{}' in an OP file", option.key, words.front()));
    return false;
  }
  return grf::replace_file(path, text.text(), diagnostics);
}

/// Reports that cameras have no place in the output, and what keeps them.
void report_cameras(std::size_t count, const ConvertOptions& options, grf::Diagnostics& diagnostics) {
  if (count == 0) return;
  diagnostics.loss(
      grf::whole_file(options.input.path),
      fmt::format("{} left out: the output NAME.op keeps them, with the scene in NAME.grf beside it",
                  counted(count, "camera was", "cameras were")));
}

/// Moves cameras with the scene.
void place_cameras(const std::vector<grf::TransformStep>& steps, std::vector<options::NamedCamera>& cameras) {
  const grf::Matrix44d matrix = grf::matrix_of(steps);
  for (options::NamedCamera& camera : cameras) {
    for (grf::Vec3f* point : {&camera.eye, &camera.target}) *point = grf::Vec3f(grf::Vec3d(*point) * matrix);
    grf::Vec3d up;
    matrix.multDirMatrix(grf::Vec3d(camera.up), up);
    camera.up = grf::Vec3f(up.normalized());
  }
}

/// Writes the page of `--report` and its pictures, and adds their paths; false after an error.
bool report_conversion(const grf::Scene& scene, const ConvertOptions& given, const ConvertOptions& options,
                       std::vector<std::string>& paths, grf::Diagnostics& diagnostics) {
  ConversionReport report;
  report.page = options.report;
  report.folder = options.report_folder;
  report.input = given.input.path;
  report.output = options.output;
  report.format = output_format(options);
  report.op_file = options.writing.op_file;
  report.losses = diagnostics.losses();
  const auto written = write_report(report, scene, diagnostics);
  if (written) paths.insert(paths.end(), written->begin(), written->end());
  return written.has_value();
}

struct Counts {
  std::size_t meshes = 0;
  std::size_t faces = 0;
};

Counts counts_of(const grf::Scene& scene) {
  Counts counts;
  grf::SceneVisitor visitor;
  const auto count = [&](const grf::Mesh& mesh) {
    ++counts.meshes;
    counts.faces += mesh.face_count();
  };
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement&, const grf::Block&) { count(mesh); };
  visitor.mesh_light = [&](const grf::MeshLight& light, const grf::Placement&, const grf::Block&) {
    count(*light.mesh);
  };
  grf::visit(scene, visitor);
  return counts;
}

void print_result(const ConvertOptions& options, const Counts& counts) {
  fmt::print("{}: {}, {}{}\n", options.output, counted(counts.meshes, "mesh", "meshes"),
             counted(counts.faces, "face", "faces"), is_dry_run(options) ? " (not written: --dry-run)" : "");
}

void print_record(const ConvertOptions& options, const Counts& counts, const WrittenFiles& files,
                  const grf::Diagnostics& diagnostics) {
  nlohmann::ordered_json json;
  json["input"] = options.input.path;
  json["output"] =
      is_dry_run(options) ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(options.output);
  json["format"] = output_format(options)->name;
  json["meshes"] = counts.meshes;
  json["faces"] = counts.faces;
  json["warnings"] = diagnostics.warning_count();
  json["losses"] = diagnostics.losses();
  json["files"] = files.paths;
  print_json(json);
}

}  // namespace

const Format* output_format(const ConvertOptions& options) {
  if (options.output_format == nullptr && is_op_file(options.output)) return find_format("grf");
  return options.output_format != nullptr ? options.output_format : format_of_name(options.output);
}

std::string written_path(const ConvertOptions& options) {
  if (!is_dry_run(options)) return options.output;
  return (std::filesystem::path(options.dry_run_folder) / grf::file_name(options.output)).string();
}

std::string problem_of(const ConvertOptions& options) {
  const Format* format = output_format(options);
  if (format == nullptr) {
    return fmt::format("the format of '{}' is unknown: give it by --to ({})", options.output,
                       formats_with(&Format::write));
  }
  if (format->write == nullptr) {
    return fmt::format("{} files cannot be written; the formats that can are: {}", format->name,
                       formats_with(&Format::write));
  }
  if ((options.flat || options.grf2008) && format->name != "grf") {
    return fmt::format("--flatten and --grf2008 are for GRF files, and this is {}", format->name);
  }
  const bool has_view = !options.writing.op_file.empty() || is_op_file(options.input.path);
  if (has_view && format->write_view == nullptr) {
    return fmt::format("an OP file cannot become {}; the formats that take one are {}", format->name,
                       formats_with(&Format::write_view));
  }
  if (!options.report.empty() && !is_report_page(options.report)) {
    return fmt::format("--report '{}': the name of a page ends in .html or .md", options.report);
  }
  if (is_op_file(options.output) && format->name != "grf") {
    return fmt::format("an OP file renders a GRF file, and this is {}", format->name);
  }
  return {};
}

bool is_op_file(const std::string& path) { return image::has_extension(path, "op"); }

ExitCode convert_file(const ConvertOptions& given) {
  grf::Diagnostics diagnostics;
  const auto resolved = with_scene_of_op_file(given, diagnostics);
  if (!resolved) {
    print(diagnostics, given.quiet);
    return ExitCode::BadInput;
  }
  ConvertOptions options = *resolved;
  const std::string op_output = is_op_file(options.output) ? options.output : "";
  if (!op_output.empty()) {
    options.output_format = output_format(options);
    options.output = std::filesystem::path(op_output).replace_extension(".grf").string();
  }
  auto input = read_input(options.input, diagnostics);
  if (input && input->format != output_format(options) && is_same_file(options.input.path, options.output)) {
    return bad_command_line(
        fmt::format("'{}' would be replaced by a file of another format", options.output));
  }
  std::optional<WrittenFiles> files;
  Counts counts;
  if (input) {
    const std::vector<EmbeddedFile> embedded = std::move(input->import.files);
    std::vector<options::NamedCamera> cameras = std::move(input->import.cameras);
    place_cameras(options.placement, cameras);
    if (op_output.empty()) report_cameras(cameras.size(), options, diagnostics);
    grf::Scene scene = changed(std::move(input->import), options, diagnostics);
    counts = counts_of(scene);
    const auto write = is_dry_run(options) ? &try_to_write_all : &write_all;
    if (diagnostics.error_count() == 0) files = write(scene, embedded, options, diagnostics);
    if (files && !op_output.empty() && !is_dry_run(options)) {
      files->paths.push_back(op_output);
      if (!write_op_file(op_output, options.output, cameras, diagnostics)) files.reset();
    }
    const bool is_reported = files && !options.report.empty();
    if (is_reported && !report_conversion(scene, given, options, files->paths, diagnostics)) files.reset();
  }
  print(diagnostics, options.quiet);
  if (!files) return ExitCode::BadInput;
  if (options.json) {
    print_record(options, counts, *files, diagnostics);
  } else if (!options.quiet) {
    print_result(options, counts);
  }
  return ExitCode::Done;
}

}  // namespace convert
