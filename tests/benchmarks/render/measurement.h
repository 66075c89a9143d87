#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/benchmarks/render/renderers.h"
#include "tests/benchmarks/render/scenes.h"

namespace benchmark {

struct Settings {
  std::filesystem::path folder;  ///< for images; references are kept there for later runs
  std::vector<Renderer> renderers;
  int size = 512;               ///< width and height, pixels
  int samples = 64;             ///< per pixel; a reference has 64 times as many
  int rounds = 3;               ///< each with its own seed, the renderers in turn
  int threads = 2;              ///< at most one per core
  bool fresh = false;           ///< renders existing references again
  bool measures_embree = true;  ///< its share of the time, and rays by kind
};

/// The measurement of one renderer on one scene.
struct Measurement {
  std::string scene;
  Renderer renderer = Renderer::Bpt;
  double seconds = 0;         ///< of the fastest round
  double relmse = 0;          ///< mean((x - reference)^2 / (reference^2 + 0.01)), over rounds too
  std::size_t fireflies = 0;  ///< in all rounds, see image::ImageError
  double peak_memory_bytes = 0;
  double paths_per_second = 0;
  std::optional<double> rays_per_second;
  std::optional<double> embree_share;  ///< fraction of the time of all threads, from a separate run
  std::vector<RayKind> ray_kinds;      ///< of bpt, from a separate run; empty if unknown
  std::optional<double> counted_rays;  ///< in that run, by the renderer itself
  grf::Colour mean = grf::Colour(0);   ///< of the reference's pixels

  double efficiency() const { return 1 / (relmse * seconds); }
};

/// Measures each renderer on a scene, Cycles only if it can make the scene, and prints progress. The
/// measurements are in the order of the renderers. Writes the references side by side as SCENE.png.
std::vector<Measurement> measure(const SceneFiles& scene, const Settings& settings,
                                 const std::function<void(const std::string&)>& say);

}  // namespace benchmark
