// Ray throughput in millions per second on one thread: camera rays, and cosine-weighted bounce rays from the
// first hits, in the Cornell box and on a bumpy mesh of 130,000 triangles.
#include <array>
#include <cmath>
#include <random>

#include <benchmark/benchmark.h>

#include "grf/read.h"
#include "renderer/transport/camera.h"
#include "renderer/transport/scene/compiled_scene.h"
#include "tests/support/paths.h"

namespace {

using transport::CompiledScene;
using transport::Ray;
using transport::Vec3f;

constexpr int Side = 512;

struct Subject {
  CompiledScene scene;
  std::vector<Ray> camera_rays;
  std::vector<Ray> bounce_rays;
};

std::vector<Ray> bounces(const CompiledScene& scene, const std::vector<Ray>& rays) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<Ray> bounced;
  for (const Ray& ray : rays) {
    const auto point = scene.intersect(ray);
    if (!point) continue;
    const bool back = ray.direction.dot(point->geometric_normal) > 0;
    const reflectance::Frame frame(back ? -point->geometric_normal : point->geometric_normal);
    const Vec3f direction = frame.to_world(reflectance::cosine_direction({uniform(random), uniform(random)}));
    bounced.push_back({point->origin_towards(direction), direction});
  }
  return bounced;
}

Subject subject_of(const grf::Scene& grf_scene, const transport::View& view) {
  grf::Diagnostics diagnostics;
  Subject subject{*transport::compile(grf_scene, diagnostics), {}, {}};
  const transport::Camera camera(view, Side, Side);
  for (int i = 0; i < Side * Side; ++i) {
    subject.camera_rays.push_back(
        camera.ray(static_cast<float>(i % Side) + 0.5F, static_cast<float>(i / Side) + 0.5F));
  }
  subject.bounce_rays = bounces(subject.scene, subject.camera_rays);
  return subject;
}

Subject cornell_box() {
  grf::Diagnostics diagnostics;
  const auto scene = grf::read(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box.grf", diagnostics);
  transport::View view;
  view.eye = Vec3f(278, 273, -800);
  view.target = Vec3f(278, 273, 0);
  view.field_of_view = 39.3F;
  return subject_of(scene.value(), view);
}

/// A square sheet of waves.
Subject bumpy_mesh() {
  constexpr std::uint32_t Quads = 256;
  grf::MeshDraft mesh;
  for (std::uint32_t i = 0; i <= Quads; ++i) {
    for (std::uint32_t k = 0; k <= Quads; ++k) {
      const float x = static_cast<float>(k) / Quads;
      const float y = static_cast<float>(i) / Quads;
      mesh.positions.emplace_back(x, y, 0.05F * std::sin(40 * x) * std::sin(40 * y));
    }
  }
  for (std::uint32_t i = 0; i < Quads; ++i) {
    for (std::uint32_t k = 0; k < Quads; ++k) {
      const std::uint32_t a = i * (Quads + 1) + k;
      mesh.add_face(std::array{a, a + 1, a + Quads + 2, a + Quads + 1}, 0);
    }
  }
  grf::Scene scene;
  scene.contents.blocks.push_back({grf::Shared<grf::Mesh>(std::move(mesh)), {}, {}});
  transport::View view;
  view.eye = Vec3f(0.5F, -0.6F, 1);
  view.target = Vec3f(0.5F, 0.5F, 0);
  return subject_of(scene, view);
}

void cast(benchmark::State& state, const CompiledScene& scene, const std::vector<Ray>& rays) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(scene.intersect(rays[i]));
    i = i + 1 == rays.size() ? 0 : i + 1;
  }
  state.counters["Mrays/s"] =
      benchmark::Counter(1e-6 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void camera_rays(benchmark::State& state, Subject (*make)()) {
  const Subject subject = make();
  cast(state, subject.scene, subject.camera_rays);
}

void bounce_rays(benchmark::State& state, Subject (*make)()) {
  const Subject subject = make();
  cast(state, subject.scene, subject.bounce_rays);
}

BENCHMARK_CAPTURE(camera_rays, cornell_box, cornell_box);
BENCHMARK_CAPTURE(bounce_rays, cornell_box, cornell_box);
BENCHMARK_CAPTURE(camera_rays, bumpy_mesh, bumpy_mesh);
BENCHMARK_CAPTURE(bounce_rays, bumpy_mesh, bumpy_mesh);

}  // namespace
