// Throughput of reading and writing GRF text, bytes per second on one core, compared with Assimp reading the
// same mesh as OBJ; peak memory of reading, relative to the scene's; and the cost of instances.
#include <cstdint>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>

#include <assimp/Importer.hpp>
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "grf/read.h"
#include "grf/write.h"
#include "tests/grf/allocation_meter.h"
#include "tests/grf/height_field.h"

namespace grf {
namespace {

/// The side of a height field whose text is about 20 MB, and of one whose text is about 200 MB: two million
/// vertices, four million triangles.
constexpr std::int64_t SmallSide = 440;
constexpr std::int64_t LargeSide = 1414;

std::uint32_t side_of(const benchmark::State& state) { return static_cast<std::uint32_t>(state.range(0)); }

void report_bytes(benchmark::State& state, std::size_t bytes_of_one) {
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(bytes_of_one));
}

void read_mesh(benchmark::State& state) {
  std::string text = to_text(scene_of_mesh(height_field(side_of(state))));
  const std::size_t bytes = text.size();
  double memory = 0;
  for (auto _ : state) {
    state.PauseTiming();
    const std::size_t before = allocated_bytes();
    restart_peak();
    std::string copy = text;
    state.ResumeTiming();
    Diagnostics diagnostics;
    const std::optional<Scene> scene = read_text(std::move(copy), "mesh.grf", diagnostics);
    if (!scene) throw std::logic_error(diagnostics.to_text());
    memory = static_cast<double>(peak_bytes() - before) /
             static_cast<double>(bytes_of(*std::get<Shared<Mesh>>(scene->contents.blocks.front().content)));
  }
  report_bytes(state, bytes);
  state.counters["peak_memory_over_scene"] = memory;
}

void write_mesh(benchmark::State& state) {
  const Scene scene = scene_of_mesh(height_field(side_of(state)));
  std::size_t bytes = 0;
  for (auto _ : state) {
    const std::string text = to_text(scene);
    bytes = text.size();
    benchmark::DoNotOptimize(text.data());
  }
  report_bytes(state, bytes);
}

std::string obj_text(const Mesh& mesh) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
    const Vec3f& p = mesh.geometry->positions[i];
    const Vec3f& n = mesh.geometry->normals[i];
    fmt::format_to(out, "v {} {} {}\nvn {} {} {}\n", p.x, p.y, p.z, n.x, n.y, n.z);
  }
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    text += 'f';
    for (const std::uint32_t corner : mesh.face(i)) fmt::format_to(out, " {0}//{0}", corner + 1);
    text += '\n';
  }
  return text;
}

void read_obj_by_assimp(benchmark::State& state) {
  const std::string text = obj_text(height_field(side_of(state)));
  for (auto _ : state) {
    Assimp::Importer importer;
    if (importer.ReadFileFromMemory(text.data(), text.size(), 0, "obj") == nullptr) {
      throw std::logic_error(importer.GetErrorString());
    }
  }
  report_bytes(state, text.size());
}

/// A mesh of 100,000 triangles, defined once and placed this many times, each under its own transform.
std::string text_of_instances(std::int64_t count) {
  Scene scene;
  DefinitionScope scope;
  scope.definitions.push_back({"m", Shared<Mesh>(height_field(225)), {}, {}});
  for (std::int64_t i = 0; i < count; ++i) {
    Transform transform;
    transform.steps = {{TransformStep::Kind::Rotation, Vec3f(0, static_cast<float>(i) / 7, 0)},
                       {TransformStep::Kind::Translation, Vec3f(static_cast<float>(i), 0, 0.1F)}};
    transform.body.blocks.push_back({Use{{"m", {}}}, {}, {}});
    scope.body.blocks.push_back({std::move(transform), {}, {}});
  }
  scene.contents.blocks.push_back({std::move(scope), {}, {}});
  return to_text(scene);
}

void read_instances(benchmark::State& state) {
  const std::string text = text_of_instances(state.range(0));
  std::size_t bytes = 0;
  for (auto _ : state) {
    const std::size_t before = allocated_bytes();
    Diagnostics diagnostics;
    const std::optional<Scene> scene = read_text(text, "instances.grf", diagnostics);
    if (!scene) throw std::logic_error(diagnostics.to_text());
    bytes = allocated_bytes() - before;
  }
  state.counters["scene_bytes"] = static_cast<double>(bytes);
}

BENCHMARK(read_mesh)->Arg(SmallSide)->Arg(LargeSide)->Unit(benchmark::kMillisecond);
BENCHMARK(write_mesh)->Arg(SmallSide)->Arg(LargeSide)->Unit(benchmark::kMillisecond);
BENCHMARK(read_obj_by_assimp)->Arg(SmallSide)->Arg(LargeSide)->Unit(benchmark::kMillisecond);
BENCHMARK(read_instances)->Arg(1)->Arg(10'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace grf
