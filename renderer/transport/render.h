#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <vector>

#include "renderer/transport/camera.h"
#include "renderer/transport/film.h"
#include "renderer/transport/integrators/kernel.h"
#include "renderer/transport/sample_placement.h"
#include "renderer/transport/tile_queue.h"

namespace transport {

/// Where in a pixel its samples lie.
enum class PixelPlacing {
  Sobol,    ///< evenly spread, and each anywhere
  Regular,  ///< in the middles of the cells of a grid
  Centre,   ///< all in the middle
};

struct RenderSettings {
  /// Of samples a pixel, where time or error say when to stop.
  static constexpr int Unlimited = std::numeric_limits<int>::max();
  /// That the true error may be above the target, in no more than 1 of 40 renders.
  static constexpr double ErrorMargin = 1.15;

  int width = 500;
  int height = 400;
  View view;
  IntegratorSettings integrator;
  std::shared_ptr<const Image> backplate;  ///< seen behind the scene, fitted to the image; null: none
  int samples = 100;                       ///< a pixel, at most; the mean over pixels if adaptive
  /// More samples where the error is; see SamplePlacement. Has no effect unless placing is Sobol.
  bool adaptive = false;
  /// Stops once the estimated error is no more than this, and its upper bound no more than `ErrorMargin`
  /// times this.
  std::optional<double> target_error;
  std::optional<double> max_seconds;  ///< stops after so long, with what there is
  PixelPlacing placing = PixelPlacing::Sobol;
  int grid_columns = 1;  ///< of a regular placing; its rows follow from the samples
  Points points = Points::Sobol;
  std::uint32_t seed = 0;
  int threads = 0;  ///< 0: as many as the machine has
};

/// What was done for an image so far, in all runs together if it was resumed.
struct RenderTotals {
  std::uint64_t paths = 0;
  std::uint64_t rays = 0;
  /// Samples that were not finite, and count as black.
  std::uint64_t rejected = 0;
  /// The first pixel, row by row from the top, that has such a sample: its index.
  std::uint64_t first_rejected = std::numeric_limits<std::uint64_t>::max();
  double seconds = 0;
  /// Spent in sampling schemes to draw directions, by all threads together, if PathSettings asks to measure
  /// it; else 0.
  double sampling_seconds = 0;
};

struct RenderProgress {
  double done = 0;  ///< 0..1, towards whichever of samples, error and time is there first
  double seconds = 0;
  std::optional<double> seconds_left;     ///< nothing while that cannot be known
  std::optional<double> estimated_error;  ///< nothing while there are no two halves
};

/// An image as it is at the moment.
struct Snapshot {
  Image mean;
  Image variance;  ///< of the mean; empty unless asked for
};

/// Why a render came to its end.
enum class RenderEnd { NotYet, Samples, TargetError, Time, Stopped };

/// A running render: one image of one scene. `run` is called once; the other functions may be called from any
/// thread meanwhile.
class Render {
 public:
  /// The scene must outlive the render.
  Render(const CompiledScene& scene, const RenderSettings& settings);

  /// Takes up what another render of the same image had; to be called before `run`.
  void restore(const RenderTotals& totals);
  void restore_tile(int tile, const FilmTile& sums);

  /// Renders to the last sample, or to the target error, until time is up, or until `stop`. The image depends
  /// on the settings alone, whatever the number of threads, and whether or not it was resumed; unless time or
  /// `stop` ended it, when tiles may differ by some samples.
  ///
  /// The error is looked at when pixels have as many samples as are meant for them at some mean number, and
  /// these numbers grow by a fifth each time: looking at an uncertain number often would find it low too
  /// early.
  void run();

  /// Makes `run` return soon, with the image as it is. Safe to call from a signal handler.
  void stop() { stopped_ = true; }
  bool is_stopped() const { return stopped_; }
  /// NotYet while it runs.
  RenderEnd end() const { return end_; }

  RenderProgress progress() const;
  RenderTotals totals() const;
  double seconds() const { return totals().seconds; }
  std::uint64_t ray_count() const { return totals().rays; }
  std::uint64_t path_count() const { return totals().paths; }
  double sampling_seconds() const { return totals().sampling_seconds; }
  std::uint64_t rejected_samples() const { return totals().rejected; }
  /// Why the first pixel that has samples which were not finite has them: its samples are drawn once more, up
  /// to the first such one. A term without a name: each was finite, and their product was not. Once `run` has
  /// returned; nothing if there are no such samples.
  std::optional<NotFinite> cause_of_rejection() const;
  /// The mean over pixels.
  double samples_per_pixel() const;

  /// The image so far. Workers go on; each tile is as some moment left it.
  Snapshot snapshot(bool with_variance = false) const;
  /// The same for one tile.
  void copy_tile(int tile, FilmTile& copy) const;
  std::uint32_t sample_count_of(int tile) const;

  const RenderSettings& settings() const { return settings_; }

  /// Once `run` has returned; before that, only sizes and bounds.
  const Film& film() const { return film_; }
  /// Returns the film's error estimate, made on as many threads as the settings allow. Once `run` has
  /// returned.
  std::optional<ErrorEstimate> error_estimate() const;

 private:
  RenderEnd run_stages();
  bool is_adaptive() const { return settings_.adaptive && settings_.placing == PixelPlacing::Sobol; }
  int stage_from(int samples) const;
  std::vector<FilmTile::Counts> counts_at(int samples) const;
  bool exceeds(int samples) const;
  bool has_pilot() const;
  bool run_stage(int samples);
  bool reaches_target(int samples);
  void work(TileQueue& queue);
  bool render_tile(const TileWork& work, FilmTile& tile);
  void render_pixel(const TileWork& work, int x, int y, FilmTile& tile, RenderTotals& done,
                    RayCounter& counter) const;
  void keep_tile(const TileWork& work, const FilmTile& tile, const RenderTotals& done,
                 std::uint64_t sampling_ticks);
  Rgb sample(Kernel kernel, int x, int y, int scrambling, std::uint32_t number, RayCounter& counter) const;
  grf::Vec2f place_in_pixel(int sample, PathNumbers& numbers) const;
  std::optional<Rgb> behind(float x, float y) const;
  bool ends_early();
  double elapsed() const;
  double pixel_count() const;
  double convergence() const;
  double samples_needed(double samples, const std::optional<ErrorEstimate>& estimate) const;

  /// What a check of the error found.
  struct Check {
    double samples = 0;
    double error = 0;
  };

  std::mutex& lock_of(int tile) const {
    return tile_locks_[static_cast<std::size_t>(tile) % tile_locks_.size()];
  }

  const CompiledScene& scene_;
  RenderSettings settings_;
  Kernel kernel_;
  Camera camera_;
  Film film_;
  std::optional<SamplePlacement> placement_;  ///< once the pilot is done
  /// Held while a tile of the film is copied or put back: for about a microsecond, each some milliseconds.
  mutable std::array<std::mutex, 64> tile_locks_;
  const std::chrono::steady_clock::time_point start_;
  const std::uint64_t start_ticks_;
  std::atomic<bool> stopped_ = false;
  std::atomic<bool> out_of_time_ = false;
  std::atomic<RenderEnd> end_ = RenderEnd::NotYet;

  mutable std::mutex totals_lock_;  ///< of what follows
  RenderTotals totals_;             ///< seconds are those of earlier runs
  std::uint64_t restored_paths_ = 0;
  std::uint64_t sampling_ticks_ = 0;
  ErrorSums error_sums_;  ///< about Film's, in the order in which tiles were done
  std::vector<Check> checks_;
};

}  // namespace transport
