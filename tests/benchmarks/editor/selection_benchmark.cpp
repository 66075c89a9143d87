// How long the window is busy while faces of a large scene are chosen. A torus of 1,000,000 quadrilaterals.
#include <cmath>
#include <functional>
#include <numbers>

#include <benchmark/benchmark.h>

#include "editor/document/face_loops.h"
#include "editor/document/face_query.h"

namespace editor {
namespace {

constexpr std::uint32_t Side = 1000;

/// The faces of a torus have areas of all sizes between the inner and the outer equator, and all directions.
SceneObjects large_torus() {
  grf::MeshDraft draft;
  for (std::uint32_t i = 0; i < Side; ++i) {
    for (std::uint32_t k = 0; k < Side; ++k) {
      const double phi = 2 * std::numbers::pi * i / Side;
      const double theta = 2 * std::numbers::pi * k / Side;
      const double radius = 2 + std::cos(theta);
      draft.positions.emplace_back(
          grf::Vec3d(radius * std::cos(phi), std::sin(theta), radius * std::sin(phi)));
      const auto vertex = [](std::uint32_t at, std::uint32_t across) {
        return at % Side * Side + across % Side;
      };
      draft.add_face(std::vector{vertex(i, k), vertex(i, k + 1), vertex(i + 1, k + 1), vertex(i + 1, k)}, 0);
    }
  }
  grf::Scene scene;
  scene.contents.blocks.emplace_back().content = grf::Shared<grf::Mesh>(grf::Mesh(std::move(draft)));
  return objects_of(scene, "");
}

/// A scene with half of its faces selected.
struct LargeScene {
  SceneObjects objects = large_torus();
  FaceSelection one{objects};
  FaceSelection half{objects};

  LargeScene() {
    one.set({0, Side * Side / 2});
    for (std::uint32_t face = 0; face < Side * Side; ++face) {
      if (face % Side < Side / 2) half.set({0, face});
    }
  }
};

const LargeScene& large_scene() {
  static const LargeScene scene;
  return scene;
}

/// What a geometry computes once, in a thread as soon as a face is selected.
void find_edges(benchmark::State& state) {
  for (auto _ : state) {  // NOLINT(clang-analyzer-deadcode.DeadStores): Google Benchmark's way
    state.PauseTiming();
    const grf::SharedGeometry geometry = grf::Geometry(*large_scene().objects.meshes[0].mesh->geometry);
    state.ResumeTiming();
    benchmark::DoNotOptimize(&geometry.edges());
  }
}

void find_area_vectors(benchmark::State& state) {
  for (auto _ : state) {  // NOLINT(clang-analyzer-deadcode.DeadStores): Google Benchmark's way
    state.PauseTiming();
    const grf::SharedGeometry geometry = grf::Geometry(*large_scene().objects.meshes[0].mesh->geometry);
    state.ResumeTiming();
    benchmark::DoNotOptimize(geometry.area_vectors().data());
  }
}

using Choice = std::function<FaceSelection(const LargeScene& scene)>;

FaceQuery by_all() {
  FaceQuery query;
  query.normal = DirectionRange{{0, 1, 0}, 1};
  query.area = {0, 1};
  query.height = {-0.5, 1};
  query.material = "dif*";
  query.similarity = Similarity::of_surface();
  query.similarity.object = true;
  query.similarity.normal_radians = 2;
  query.similarity.area_fraction = 0.5;
  return query;
}

void add(const char* name, const Choice& choice) {
  const auto run = [choice](benchmark::State& state) {
    const LargeScene& scene = large_scene();
    std::size_t count = choice(scene).count();  // what is kept with the geometry is computed
    for (auto _ : state)  // NOLINT(clang-analyzer-deadcode.DeadStores): Google Benchmark's way
      benchmark::DoNotOptimize(count = choice(scene).count());
    state.counters["faces"] = static_cast<double>(count);
  };
  benchmark::RegisterBenchmark(name, run)->Unit(benchmark::kMillisecond);
}

void add_queries() {
  const auto add_query = [](const char* name, const FaceQuery& query) {
    add(name, [query](const LargeScene& scene) { return find_faces(query, scene.half, scene.objects); });
  };
  FaceQuery query;
  query.normal = DirectionRange{{0, 1, 0}, 0.5};
  add_query("by normal", query);
  query = {};
  query.area.least = 2e-5;
  add_query("by area", query);
  query = {};
  query.height = {0, 0.5};
  add_query("by height", query);
  query = {};
  query.material = "dif*";
  add_query("by material", query);
  query = {};
  query.similarity = Similarity::of_surface();
  add_query("similar surface", query);
  query = {};
  query.similarity.normal_radians = 1;
  query.similarity.area_fraction = 0.5;
  add_query("similar normal and area", query);
  add_query("by all conditions", by_all());
}

void add_all() {
  benchmark::RegisterBenchmark("edges, once", find_edges)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("area vectors, once", find_area_vectors)->Unit(benchmark::kMillisecond);
  add("invert", [](const LargeScene& scene) {
    FaceSelection selection = scene.half;
    selection.invert();
    return selection;
  });
  add("grow", [](const LargeScene& scene) { return grown(scene.half, scene.objects); });
  add("shrink", [](const LargeScene& scene) { return shrunk(scene.half, scene.objects); });
  add("connected", [](const LargeScene& scene) { return connected(scene.one, scene.objects); });
  add("coplanar", [](const LargeScene& scene) { return coplanar(scene.one, scene.objects, 0.5); });
  add("loop", [](const LargeScene& scene) { return face_loop(scene.objects, {0, 0}, 0); });
  add("crossing loop", [](const LargeScene& scene) { return crossing_face_loop(scene.objects, {0, 0}, 0); });
  add_queries();
}

}  // namespace
}  // namespace editor

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  editor::add_all();
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
