// Time and peak memory of reading a GLB file of a million triangles, compared with tinygltf only loading it.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <tiny_gltf.h>

#include "converters/format.h"
#include "tests/converters/gltf/gltf_maker.h"
#include "tests/grf/allocation_meter.h"
#include "tests/support/temporary_folder.h"

namespace {

/// A wavy square with this many vertices per side, with normals and texture coordinates.
std::string wavy_square(std::uint32_t side) {
  std::vector<float> positions;
  std::vector<float> normals;
  std::vector<float> uvs;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const auto x = static_cast<float>(i % side);
    const auto y = static_cast<float>(i / side);
    positions.insert(positions.end(), {x, y, std::sin(0.1F * x) * std::cos(0.1F * y)});
    normals.insert(normals.end(), {0, 0, 1});
    uvs.insert(uvs.end(), {x / static_cast<float>(side), y / static_cast<float>(side)});
    if (i % side + 1 == side || i / side + 1 == side) continue;
    indices.insert(indices.end(), {i, i + 1, i + side + 1, i, i + side + 1, i + side});
  }
  convert::GltfMaker maker;
  maker.add_mesh({{"attributes",
                   {{"POSITION", maker.floats(positions, "VEC3")},
                    {"NORMAL", maker.floats(normals, "VEC3")},
                    {"TEXCOORD_0", maker.floats(uvs, "VEC2")}}},
                  {"indices", maker.add(indices, "SCALAR", 5125)}});
  return maker.glb();
}

/// The file of 1,000,000 triangles (708 x 708 vertices).
const std::string& million_triangles() {
  static const std::string bytes = wavy_square(708);
  return bytes;
}

/// Runs a reader on the file, and measures bytes and memory.
template <class Read>
void measure(benchmark::State& state, const Read& read) {
  const test::TemporaryFolder folder;
  const std::string path = folder.add("million.glb", million_triangles());
  std::size_t memory = 0;
  for (auto _ : state) {
    const std::size_t before = grf::allocated_bytes();
    grf::restart_peak();
    read(path);
    memory = grf::peak_bytes() - before;
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(million_triangles().size()));
  state.counters["peak_bytes"] = static_cast<double>(memory);
}

void read_glb(benchmark::State& state) {
  measure(state, [](const std::string& path) {
    grf::Diagnostics diagnostics;
    const auto import = convert::read(*convert::find_format("glb"), path, {}, diagnostics);
    if (!import) throw std::runtime_error(diagnostics.to_text());
  });
}
BENCHMARK(read_glb)->Unit(benchmark::kMillisecond);

void read_glb_by_tinygltf_alone(benchmark::State& state) {
  measure(state, [](const std::string& path) {
    tinygltf::Model model;
    tinygltf::TinyGLTF parser;
    std::string errors;
    std::string warnings;
    if (!parser.LoadBinaryFromFile(&model, &errors, &warnings, path)) throw std::runtime_error(errors);
  });
}
BENCHMARK(read_glb_by_tinygltf_alone)->Unit(benchmark::kMillisecond);

}  // namespace
