#include "converters/command/info.h"

#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/summary.h"
#include "grf/write.h"

namespace convert {
namespace {

nlohmann::ordered_json to_json(const grf::Vec3f& v) {
  return {grf::shortest(v.x), grf::shortest(v.y), grf::shortest(v.z)};
}

nlohmann::ordered_json to_json(const Format& format, const grf::Summary& summary, std::size_t warnings) {
  nlohmann::ordered_json json;
  json["format"] = format.name;
  json["meshes"] = summary.meshes;
  json["vertices"] = summary.vertices;
  json["faces"] = summary.faces;
  json["triangles"] = summary.triangles;
  json["instances"] = summary.instances;
  json["lights"] = summary.lights;
  json["brdfs"] = summary.brdfs;
  json["pdfs"] = summary.pdfs;
  json["textures"] = summary.textures;
  if (summary.bounds.isEmpty()) {
    json["bounds"] = nullptr;
  } else {
    json["bounds"] = {{"min", to_json(summary.bounds.min)}, {"max", to_json(summary.bounds.max)}};
  }
  json["area"] = summary.area;
  json["boundary_edges"] = summary.boundary_edges;
  json["nonmanifold_edges"] = summary.nonmanifold_edges;
  json["warnings"] = warnings;
  return json;
}

std::string to_text(const grf::Vec3f& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

void print_row(std::string_view label, const std::string& value) {
  fmt::print("  {:<18} {}\n", label, value);
}
void print_row(std::string_view label, std::size_t count) { print_row(label, fmt::format("{}", count)); }

void print_table(const std::string& path, const Format& format, const grf::Summary& summary,
                 std::size_t warnings) {
  fmt::print("{}\n", path);
  print_row("format", std::string(format.title));
  print_row("meshes", summary.meshes);
  print_row("vertices", summary.vertices);
  print_row("faces", summary.faces);
  print_row("triangles", summary.triangles);
  print_row("instances", summary.instances);
  print_row("lights", summary.lights);
  print_row("BRDFs", summary.brdfs);
  print_row("PDFs", summary.pdfs);
  print_row("textures", summary.textures);
  if (!summary.bounds.isEmpty()) {
    print_row("bounds", fmt::format("{} to {}", to_text(summary.bounds.min), to_text(summary.bounds.max)));
    print_row("size", to_text(summary.bounds.size()));
  }
  print_row("area", fmt::format("{:.6g}", summary.area));
  print_row("boundary edges", summary.boundary_edges);
  print_row("non-manifold edges", summary.nonmanifold_edges);
  print_row("warnings", warnings);
}

}  // namespace

ExitCode print_info(const InputOptions& options, bool json, bool quiet) {
  grf::Diagnostics diagnostics;
  const auto input = read_input(options, diagnostics);
  print(diagnostics, quiet);
  if (!input) return ExitCode::BadInput;
  const grf::Summary summary = grf::summarize(input->scene);
  if (json) {
    fmt::print("{}\n", to_json(*input->format, summary, diagnostics.warning_count()).dump(2));
  } else {
    print_table(options.path, *input->format, summary, diagnostics.warning_count());
  }
  return ExitCode::Done;
}

}  // namespace convert
