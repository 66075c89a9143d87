// How fast GRF text is read and written: bytes per second of one core.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "grf/read.h"
#include "grf/write.h"

namespace grf {
namespace {

/// A height field of triangles, with a normal for each vertex: what most of a large scene's text looks like.
Mesh height_field(std::uint32_t side) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const float x = static_cast<float>(i % side) / static_cast<float>(side);
    const float y = static_cast<float>(i / side) / static_cast<float>(side);
    mesh.positions.emplace_back(x, y, std::sin(9 * x) * std::cos(7 * y) / 5);
    mesh.normals.set(i, Vec3f(-1.8F * std::cos(9 * x), 1.4F * std::sin(7 * y), 1).normalized());
  }
  for (std::uint32_t row = 0; row + 1 < side; ++row) {
    for (std::uint32_t column = 0; column + 1 < side; ++column) {
      const std::uint32_t corner = row * side + column;
      const std::uint32_t lower[] = {corner, corner + 1, corner + side};
      const std::uint32_t upper[] = {corner + 1, corner + side + 1, corner + side};
      mesh.add_face(lower, 0);
      mesh.add_face(upper, 0);
    }
  }
  return mesh;
}

Scene scene_of_about(std::size_t bytes) {
  constexpr double BytesOfAVertex = 130;  // and of the two faces that come with it
  Scene scene;
  Block block;
  block.content = Shared<Mesh>(
      height_field(static_cast<std::uint32_t>(std::sqrt(static_cast<double>(bytes) / BytesOfAVertex))));
  scene.contents.blocks.push_back(std::move(block));
  return scene;
}

void report_bytes(benchmark::State& state, std::size_t bytes_of_one) {
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(bytes_of_one));
}

void read_mesh(benchmark::State& state) {
  const std::string text = to_text(scene_of_about(static_cast<std::size_t>(state.range(0))));
  for (auto _ : state) {
    Diagnostics diagnostics;
    std::optional<Scene> scene = read_text(text, "mesh.grf", diagnostics);
    if (!scene) throw std::logic_error(diagnostics.to_text());
    benchmark::DoNotOptimize(scene);
  }
  report_bytes(state, text.size());
}

void write_mesh(benchmark::State& state) {
  const Scene scene = scene_of_about(static_cast<std::size_t>(state.range(0)));
  std::size_t bytes = 0;
  for (auto _ : state) {
    const std::string text = to_text(scene);
    bytes = text.size();
    benchmark::DoNotOptimize(text.data());
  }
  report_bytes(state, bytes);
}

constexpr std::int64_t TwentyMegabytes = 20'000'000;

BENCHMARK(read_mesh)->Arg(TwentyMegabytes)->Unit(benchmark::kMillisecond);
BENCHMARK(write_mesh)->Arg(TwentyMegabytes)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace grf
