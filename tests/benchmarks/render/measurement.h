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
  int size = 512;      ///< width and height, pixels
  int samples = 64;    ///< a pixel; a reference has 64 times as many
  int rounds = 3;      ///< each with a seed of its own, the renderers in turn
  int threads = 2;     ///< at most as many as there are cores
  bool fresh = false;  ///< renders references that are there already once more
  bool measures_embree = true;
};

/// One renderer on one scene.
struct Measurement {
  std::string scene;
  Renderer renderer = Renderer::Bpt;
  double seconds = 0;         ///< of the fastest round
  double relmse = 0;          ///< mean((x - reference)^2 / (reference^2 + 0.01)), over rounds too
  std::size_t fireflies = 0;  ///< of all rounds, see transport::ImageError
  double peak_memory_bytes = 0;
  double paths_per_second = 0;
  std::optional<double> rays_per_second;
  std::optional<double> embree_share;           ///< of the time of all threads, from a run of its own
  reflectance::Rgb mean = reflectance::Rgb(0);  ///< of the reference's pixels

  double efficiency() const { return 1 / (relmse * seconds); }
};

/// Renders a scene by each renderer, and says what it does as it goes on. The measurements are in the order
/// of the renderers. Leaves a picture of the references side by side as SCENE.png.
std::vector<Measurement> measure(const SceneFiles& scene, const Settings& settings,
                                 const std::function<void(const std::string&)>& say);

}  // namespace benchmark
