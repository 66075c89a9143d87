#include "converters/command/info.h"

#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "converters/command/file_work.h"
#include "converters/wording.h"
#include "grf/summary.h"
#include "grf/write.h"

namespace convert {
namespace {

nlohmann::ordered_json to_json(const grf::Vec3f& v) {
  return {grf::shortest(v.x), grf::shortest(v.y), grf::shortest(v.z)};
}

nlohmann::ordered_json to_json(const grf::MeshSummary& mesh) {
  return {{"name", mesh.name},
          {"vertices", mesh.vertices},
          {"faces", mesh.faces},
          {"boundary_edges", mesh.topology.boundary_edges},
          {"boundary_loops", mesh.topology.boundary_loops},
          {"nonmanifold_edges", mesh.topology.nonmanifold_edges},
          {"nonmanifold_vertices", mesh.topology.nonmanifold_vertices}};
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
  json["boundary_loops"] = summary.boundary_loops;
  json["nonmanifold_edges"] = summary.nonmanifold_edges;
  json["nonmanifold_vertices"] = summary.nonmanifold_vertices;
  json["different_meshes"] = nlohmann::ordered_json::array();
  for (const grf::MeshSummary& mesh : summary.different_meshes)
    json["different_meshes"].push_back(to_json(mesh));
  json["warnings"] = warnings;
  return json;
}

std::string to_text(const grf::Vec3f& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

void print_row(std::string_view label, const std::string& value) {
  fmt::print("  {:<18} {}\n", label, value);
}
void print_row(std::string_view label, std::size_t count) { print_row(label, fmt::format("{}", count)); }

bool is_closed_manifold(const grf::Topology& topology) {
  return topology.boundary_edges == 0 && topology.nonmanifold_edges == 0 &&
         topology.nonmanifold_vertices == 0;
}

/// Prints each mesh with topological defects, by its name and index.
void print_topology(const grf::Summary& summary) {
  print_row("boundary edges", summary.boundary_edges);
  print_row("boundary loops", summary.boundary_loops);
  print_row("non-manifold edges", summary.nonmanifold_edges);
  print_row("non-manifold vertices", summary.nonmanifold_vertices);
  if (summary.different_meshes.size() < 2) return;
  for (std::size_t i = 0; i < summary.different_meshes.size(); ++i) {
    const grf::MeshSummary& mesh = summary.different_meshes[i];
    const grf::Topology& topology = mesh.topology;
    if (is_closed_manifold(topology)) continue;
    const std::string name = mesh.name.empty() ? "" : fmt::format(" '{}'", mesh.name);
    print_row(
        fmt::format("  mesh {}{}", i + 1, name),
        fmt::format("{}, {}, {}", counted(topology.boundary_loops, "boundary loop", "boundary loops"),
                    counted(topology.nonmanifold_edges, "non-manifold edge", "non-manifold edges"),
                    counted(topology.nonmanifold_vertices, "non-manifold vertex", "non-manifold vertices")));
  }
}

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
  print_topology(summary);
  print_row("warnings", warnings);
}

ExitCode print_figures(const InputOptions& options, bool json, bool quiet) {
  grf::Diagnostics diagnostics;
  const auto input = read_input(options, diagnostics);
  print(diagnostics, quiet);
  if (!input) return ExitCode::BadInput;
  const grf::Summary summary = grf::summarize(input->import.scene);
  if (json) {
    print_json(to_json(*input->format, summary, diagnostics.warning_count()));
  } else {
    print_table(options.path, *input->format, summary, diagnostics.warning_count());
  }
  return ExitCode::Done;
}

}  // namespace

ExitCode print_info(const InputOptions& options, bool json, bool quiet, const Limits& limits) {
  FileWork work;
  work.inputs = {options.path};
  work.limits = limits;
  work.work = [&](std::size_t) { return print_figures(options, json, quiet); };
  work.done = [](const FileWork::Result& result) { fmt::print("{}", result.out); };
  return run(work);
}

}  // namespace convert
