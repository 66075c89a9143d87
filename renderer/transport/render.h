#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

#include "renderer/transport/camera.h"
#include "renderer/transport/film.h"
#include "renderer/transport/integrators/kernel.h"

namespace transport {

/// Where in a pixel its samples lie.
enum class PixelPlacing {
  Sobol,    ///< evenly spread, and each anywhere
  Regular,  ///< in the middles of the cells of a grid
  Centre,   ///< all in the middle
};

struct RenderSettings {
  int width = 500;
  int height = 400;
  View view;
  IntegratorSettings integrator;
  std::shared_ptr<const Image> backplate;  ///< seen behind the scene, fitted to the image; null: none
  int samples = 100;                       ///< a pixel
  PixelPlacing placing = PixelPlacing::Sobol;
  int grid_columns = 1;  ///< of a regular placing; its rows follow from the samples
  std::uint32_t seed = 0;
  int threads = 0;  ///< 0: as many as the machine has
};

struct RenderProgress {
  double done = 0;  ///< 0..1
  double seconds = 0;
  double seconds_left = 0;
};

/// A running render: one image of one scene. `run` is called once; the other functions may be called from any
/// thread meanwhile.
class Render {
 public:
  /// The scene must outlive the render.
  Render(const CompiledScene& scene, const RenderSettings& settings);

  /// Renders to the last sample, or until `stop`. The image depends on the settings alone, whatever the
  /// number of threads.
  void run();

  /// Makes `run` return soon, with the image as it is. Safe to call from a signal handler.
  void stop() { stopped_ = true; }
  bool is_stopped() const { return stopped_; }

  RenderProgress progress() const;

  // Once `run` has returned:
  const Film& film() const { return film_; }
  /// Since the render was made.
  double seconds() const { return seconds_; }
  std::uint64_t ray_count() const { return rays_; }
  std::uint64_t path_count() const { return paths_; }
  /// Spent in sampling schemes to draw directions, by all threads together, if IntegratorSettings asks to
  /// measure it; else 0.
  double sampling_seconds() const;
  /// Samples that were not finite, and count as black.
  std::uint64_t rejected_samples() const { return rejected_; }

 private:
  void run_pass(int first_sample, int last_sample);
  void render_tile(int tile_x, int tile_y, int first_sample, int last_sample);
  int render_pixel(int x, int y, int first_sample, int last_sample, RayCounter& counter);
  grf::Vec2f place_in_pixel(int sample, PathNumbers& numbers) const;
  std::optional<Rgb> behind(float x, float y) const;
  double elapsed() const;

  const CompiledScene& scene_;
  RenderSettings settings_;
  Kernel kernel_;
  Camera camera_;
  Film film_;
  const std::chrono::steady_clock::time_point start_;
  const std::uint64_t start_ticks_;
  double seconds_ = 0;
  double ticks_per_second_ = 1;
  std::atomic<bool> stopped_ = false;
  std::atomic<std::uint64_t> paths_ = 0;
  std::atomic<std::uint64_t> rays_ = 0;
  std::atomic<std::uint64_t> sampling_ticks_ = 0;
  std::atomic<std::uint64_t> rejected_ = 0;
};

}  // namespace transport
