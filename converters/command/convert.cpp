#include "converters/command/convert.h"

#include <cstdio>

#include <fmt/format.h>

#include "converters/wording.h"
#include "grf/grf2008.h"
#include "grf/relocate.h"
#include "grf/text_file.h"
#include "grf/visit.h"

namespace convert {
namespace {

std::string writable_formats() {
  std::string names;
  for (const Format& format : formats()) {
    if (format.write != nullptr) names += fmt::format("{}{}", names.empty() ? "" : ", ", format.name);
  }
  return names;
}

/// What is wrong with a format as one to write, or an empty string.
std::string why_not_written(const Format* format, const std::string& path) {
  if (format == nullptr) {
    return fmt::format("the name '{}' does not say its format: give it by --to ({})", path,
                       writable_formats());
  }
  if (format->write != nullptr) return "";
  return fmt::format("{} files are not written; what is: {}", format->name, writable_formats());
}

bool is_same_file(const std::string& a, const std::string& b) {
  return grf::canonical_path(a) == grf::canonical_path(b);
}

/// The scene as it is to be written, or nothing after an error.
std::optional<grf::Scene> prepared(const Input& input, const ConvertOptions& options,
                                   grf::Diagnostics& diagnostics) {
  grf::Scene scene = options.flat ? grf::flatten(input.scene, options.input.path) : input.scene;
  grf::relocate(scene, options.input.path, options.output);
  if (!options.grf2008) return scene;
  return grf::to_grf2008(scene, options.output, diagnostics);
}

void print_result(const grf::Scene& scene, const std::string& path) {
  std::size_t meshes = 0;
  std::size_t faces = 0;
  grf::SceneVisitor visitor;
  const auto count = [&](const grf::Mesh& mesh) {
    ++meshes;
    faces += mesh.face_count();
  };
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement&, const grf::Block&) { count(mesh); };
  visitor.mesh_light = [&](const grf::MeshLight& light, const grf::Placement&, const grf::Block&) {
    count(*light.mesh);
  };
  grf::visit(scene, visitor);
  fmt::print("{}: {}, {}\n", path, counted(meshes, "mesh", "meshes"), counted(faces, "face", "faces"));
}

}  // namespace

ExitCode convert_file(const ConvertOptions& options) {
  const Format* format = options.output_format;
  if (format == nullptr) format = format_of_name(options.output);
  const std::string why_not = why_not_written(format, options.output);
  if (!why_not.empty()) return bad_command_line(why_not);
  if ((options.flat || options.grf2008) && format->name != "grf") {
    return bad_command_line(
        fmt::format("--flatten and --grf2008 are for GRF files, and this is {}", format->name));
  }
  grf::Diagnostics diagnostics;
  const auto input = read_input(options.input, diagnostics);
  if (input && input->format != format && is_same_file(options.input.path, options.output)) {
    return bad_command_line(
        fmt::format("'{}' would be replaced by a file of another format", options.output));
  }
  const auto scene = input ? prepared(*input, options, diagnostics) : std::nullopt;
  const bool written = scene && format->write(*scene, options.output, diagnostics);
  print(diagnostics, options.quiet);
  if (!written) return ExitCode::BadInput;
  if (!options.quiet) print_result(*scene, options.output);
  return ExitCode::Done;
}

}  // namespace convert
