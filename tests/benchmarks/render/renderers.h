#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "renderer/transport/image/image.h"

namespace benchmark {

enum class Renderer { Bpt, Cycles };

/// `bpt` or `cycles`.
std::string name_of(Renderer renderer);

struct Job {
  std::filesystem::path op;
  std::filesystem::path image;  ///< EXR, to be written
  int size = 0;                 ///< width and height, pixels
  int samples = 0;              ///< a pixel
  std::uint32_t seed = 0;
  int threads = 0;
  bool measures_embree = false;  ///< slower: its seconds are no measure of the renderer
};

/// What all threads did in Embree.
struct EmbreeTime {
  double queries = 0;
  double seconds = 0;
  double share = 0;  ///< of the threads' time while the renderer traced paths
};

struct Outcome {
  double seconds = 0;  ///< of tracing paths, without start-up and files
  double peak_memory_bytes = 0;
  std::optional<double> rays;        ///< if the renderer counts them
  std::optional<EmbreeTime> embree;  ///< if the job measures it
};

/// Runs the renderer as a process of its own. Throws if it fails or does not say what it should.
Outcome render(Renderer renderer, const Job& job);

/// What `blender --version` says first; nothing if there is none.
std::optional<std::string> blender_version();

}  // namespace benchmark
