// Reading an OBJ file of a million triangles, with normals and texture coordinates, compared with Assimp's
// Importer without post-processing. Each reading has its own process, so that none reuses freed memory, and
// the two kinds alternate.
#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <assimp/Importer.hpp>
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "converters/format.h"
#include "tests/grf/height_field.h"
#include "tests/support/temporary_folder.h"

namespace convert {
namespace {

/// The side of a height field of a million triangles.
constexpr std::uint32_t Side = 709;

struct Cost {
  double seconds = std::numeric_limits<double>::max();
  double megabytes = std::numeric_limits<double>::max();
};

double seconds_of(const struct timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

/// The cost of reading the file in its own process: processor time, which other programs disturb less than
/// wall time, and peak memory.
template <class Read>
Cost cost_of(const Read& read) {
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) ::_exit(read() ? 0 : 1);
  int status = 0;
  struct rusage usage = {};
  if (::wait4(child, &status, 0, &usage) != child || status != 0) {
    throw std::runtime_error("the file could not be read");
  }
  return {seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) / 1024};
}

Cost least(const Cost& a, const Cost& b) {
  return {std::min(a.seconds, b.seconds), std::min(a.megabytes, b.megabytes)};
}

void make_file(const std::string& path) {
  grf::MeshDraft mesh(grf::height_field(Side));
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.uvs.set(i, grf::Vec2f(mesh.positions[i].x, mesh.positions[i].y) / 7.0F);
  }
  grf::Diagnostics diagnostics;
  if (!find_format("obj")->write(grf::scene_of_mesh(std::move(mesh)), path, diagnostics)) {
    throw std::runtime_error(diagnostics.to_text());
  }
}

bool read_by_assimp(const std::string& path) {
  Assimp::Importer importer;
  return importer.ReadFile(path, 0) != nullptr;
}

bool read_by_converter(const std::string& path) {
  grf::Diagnostics diagnostics;
  return read(*find_format("obj"), path, {}, diagnostics).has_value();
}

void read_obj(benchmark::State& state) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("mesh.obj");
  // Also in a separate process, or its memory would count in each reading.
  cost_of([&] {
    make_file(path);
    return true;
  });
  const double idle = cost_of([] { return true; }).megabytes;
  Cost assimp;
  Cost converter;
  for (auto _ : state) {
    assimp = least(assimp, cost_of([&] { return read_by_assimp(path); }));
    const Cost one = cost_of([&] { return read_by_converter(path); });
    converter = least(converter, one);
    state.SetIterationTime(one.seconds);
  }
  state.counters["seconds"] = converter.seconds;
  state.counters["seconds_of_assimp"] = assimp.seconds;
  state.counters["time_over_assimp"] = converter.seconds / assimp.seconds;
  state.counters["peak_MB"] = converter.megabytes - idle;
  state.counters["memory_over_assimp"] = (converter.megabytes - idle) / (assimp.megabytes - idle);
}

BENCHMARK(read_obj)->Iterations(5)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace convert
