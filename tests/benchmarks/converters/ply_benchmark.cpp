// Throughput and peak memory of reading a binary PLY file of a million triangles, through `convert::read` and
// by OpenMesh into its mesh.
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <benchmark/benchmark.h>

#include "converters/format.h"
#include "tests/grf/allocation_meter.h"
#include "tests/grf/height_field.h"
#include "tests/support/temporary_folder.h"

namespace convert {
namespace {

/// The side of a height field of a million triangles.
constexpr std::uint32_t Side = 708;

/// The file, without normals, and with face colours as floats on request.
std::string make_file(const test::TemporaryFolder& folder, bool with_colours) {
  grf::MeshDraft mesh(grf::height_field(Side));
  mesh.normals = {};
  if (with_colours) mesh.surfaces.front().colour = grf::Colour(0.123F);
  std::string path = folder.path("mesh.ply");
  grf::Diagnostics diagnostics;
  if (!find_format("ply")->write(grf::scene_of_mesh(std::move(mesh)), path, diagnostics)) {
    throw std::logic_error(diagnostics.to_text());
  }
  return path;
}

/// Runs a reader on the file, and measures bytes and memory.
template <class Read>
void measure(benchmark::State& state, bool with_colours, const Read& read) {
  const test::TemporaryFolder folder;
  const std::string path = make_file(folder, with_colours);
  const auto bytes = static_cast<std::int64_t>(std::filesystem::file_size(path));
  std::size_t memory = 0;
  for (auto _ : state) {
    const std::size_t before = grf::allocated_bytes();
    grf::restart_peak();
    read(path);
    memory = grf::peak_bytes() - before;
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * bytes);
  state.counters["peak_bytes"] = static_cast<double>(memory);
}

void read_by_converter(const std::string& path) {
  grf::Diagnostics diagnostics;
  const auto import = read(*find_format("ply"), path, {}, diagnostics);
  if (!import) throw std::logic_error(diagnostics.to_text());
}

void read_ply(benchmark::State& state) { measure(state, false, read_by_converter); }
void read_ply_with_face_colours(benchmark::State& state) { measure(state, true, read_by_converter); }

void read_by_openmesh_alone(benchmark::State& state) {
  measure(state, false, [](const std::string& path) {
    OpenMesh::TriMesh_ArrayKernelT<> mesh;
    if (!OpenMesh::IO::read_mesh(mesh, path)) throw std::logic_error("OpenMesh cannot read " + path);
  });
}

BENCHMARK(read_ply)->Unit(benchmark::kMillisecond);
BENCHMARK(read_ply_with_face_colours)->Unit(benchmark::kMillisecond);
BENCHMARK(read_by_openmesh_alone)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace convert
