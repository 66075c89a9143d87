#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "renderer/image/image.h"

namespace benchmark {

enum class Renderer { Bpt, Cycles };

/// `bpt` or `cycles`.
std::string name_of(Renderer renderer);

struct Job {
  std::filesystem::path op;
  std::filesystem::path image;  ///< EXR, to be written
  int size = 0;                 ///< width and height, pixels
  int samples = 0;              ///< per pixel
  std::uint32_t seed = 0;
  int threads = 0;
  // These are slower, so their seconds do not measure the renderer; one of them at most:
  bool measures_embree = false;
  bool records_rays = false;  ///< bpt only
};

/// The time that all threads spent in Embree.
struct EmbreeTime {
  double queries = 0;
  double seconds = 0;
  double share = 0;  ///< fraction of the threads' time while the renderer traced paths
};

/// The rays of one kind in a render.
struct RayKind {
  std::string name;  ///< `camera`, `shadow` or `bounce`
  double rays = 0;
  double embree_per_second = 0;  ///< of all threads, replaying these rays back to back
};

struct Outcome {
  double seconds = 0;  ///< of tracing paths, without start-up and files
  double peak_memory_bytes = 0;
  std::optional<double> rays;        ///< if the renderer counts them
  std::optional<EmbreeTime> embree;  ///< if the job measures it
  std::vector<RayKind> ray_kinds;    ///< if the job records them
};

/// Runs the renderer in its own process. Throws if it fails or its output is incomplete.
Outcome render(Renderer renderer, const Job& job);

/// The first line of `blender --version`; empty if it is not installed.
std::optional<std::string> blender_version();

/// The version as `blender_version` gives it. Throws std::runtime_error if Blender is not installed.
std::string required_blender_version();

}  // namespace benchmark
