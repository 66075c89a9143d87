#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <vector>

#include "renderer/transport/adaptive_sampling.h"
#include "renderer/transport/camera.h"
#include "renderer/transport/film.h"
#include "renderer/transport/forecast.h"
#include "renderer/transport/image_part.h"
#include "renderer/transport/integrators/kernel.h"
#include "renderer/transport/tile_queue.h"

namespace transport {

/// How samples are placed within a pixel.
enum class PixelSampling {
  Sobol,    ///< low-discrepancy, anywhere in the pixel
  Regular,  ///< at the centres of a regular grid's cells
  Centre,   ///< all at the centre
};

/// A probe renders a sample of an image's tiles, in order to forecast the render of the whole image.
struct ProbeSettings {
  int tiles = 0;       ///< at most; they are spread evenly over the image
  double seconds = 0;  ///< processor time per thread: the probe ends at its first error check after that
};

struct RenderSettings {
  /// No sample limit: rendering stops on time or error.
  static constexpr int Unlimited = std::numeric_limits<int>::max();
  /// How far the 97.5 % bound may exceed the target error.
  static constexpr double ErrorMargin = TargetErrorMargin;

  int width = 500;
  int height = 400;
  /// Only these pixels are rendered, as an image of that size: with the values that they have in the whole
  /// one.
  std::optional<CropWindow> crop;
  View view;
  IntegratorSettings integrator;
  std::shared_ptr<const image::Image>
      backplate;      ///< image behind the scene, fitted to the image plane; null: none
  int samples = 100;  ///< per pixel, at most; the mean over pixels if adaptive
  /// Adaptive sampling, see AdaptiveSampling. Has no effect unless `pixel_sampling` is Sobol.
  bool adaptive = false;
  /// Stops once the estimated error is at most this, and its upper bound at most `ErrorMargin` times this.
  std::optional<double> target_error;
  /// The error of the image's expected value, because light is left out; it is part of each stated error.
  ErrorEstimate bias;
  std::optional<double> max_seconds;  ///< stops after this time, with the samples so far
  std::optional<ProbeSettings> probe;
  /// Only these samples are rendered. Of an adaptive image, they are samples of the pilot, of whole tiles,
  /// unless `part_samples` has those that follow it.
  std::optional<ImagePart> part;
  /// The samples of each tile that the part has; empty if they follow from `part`.
  std::vector<TileSamples> part_samples;
  PixelSampling pixel_sampling = PixelSampling::Sobol;
  int grid_columns = 1;  ///< for a regular placing; the rows follow from the samples
  SamplePattern pattern = SamplePattern::Sobol;
  std::uint32_t seed = 0;
  int threads = 0;  ///< 0: one per core

  /// Whether samples are placed adaptively.
  bool is_adaptive() const { return adaptive && pixel_sampling == PixelSampling::Sobol; }
  /// Whether the error is checked after each stage.
  bool checks_error() const { return target_error || probe; }
};

/// Returns where the stage of a whole image ends that begins with this many samples per pixel or fewer. After
/// a stage, the render decides how it goes on: whether its error is small enough, and where samples go.
int stage_end(const RenderSettings& settings, int samples);

/// Totals of an image so far, over all runs if it was resumed.
struct RenderTotals {
  std::uint64_t paths = 0;
  std::uint64_t rays = 0;
  /// Samples that could not be added, see `ExactRgbSum::can_add`; they count as black.
  std::uint64_t rejected = 0;
  /// The index of the first pixel, row by row from the top, with such a sample.
  std::uint64_t first_rejected = std::numeric_limits<std::uint64_t>::max();
  double seconds = 0;
  /// Time spent in sampling schemes to draw directions, summed over threads; 0 unless IntegratorSettings ask
  /// to measure it.
  double sampling_seconds = 0;
};

struct RenderProgress {
  double done = 0;  ///< 0..1, towards whichever of samples, error and time comes first
  double seconds = 0;
  std::optional<double> seconds_left;     ///< empty while unknown
  std::optional<double> estimated_error;  ///< empty while there are no two halves
  std::vector<TargetForecast> forecasts;  ///< of a render with a target error, if asked for
};

/// An image at some moment of its render.
struct Snapshot {
  image::Image mean;
  image::Image variance;  ///< of the mean; empty unless asked for
};

/// Why a render ended.
enum class RenderEnd { NotYet, Samples, TargetError, Time, Stopped };

/// A running render: one image of one scene. `run` is called once; the other functions may be called from any
/// thread meanwhile.
class Render {
 public:
  /// The scene must outlive the render.
  Render(const CompiledScene& scene, const RenderSettings& settings);

  /// Returns the samples of each tile of the part that this renders; empty unless it renders one. Those of
  /// the film begin with the first of these.
  const std::vector<TileSamples>& part_samples() const { return part_samples_; }

  /// Resumes from the state of another render of the same image; to be called before `run`.
  void restore(const RenderTotals& totals);
  void restore_tile(int tile, const FilmTile& sums);

  /// Renders until the last sample, the target error, the time limit or `stop`. The image depends only on the
  /// settings, not on the number of threads or on resuming; unless time or `stop` ended it, when tiles may
  /// differ by some samples.
  ///
  /// The error is tested when pixels have the sample counts planned for certain means, which grow by a fifth
  /// each time: testing an uncertain estimate often would stop too early.
  void run();

  /// Makes `run` return soon, with the image so far. Safe to call from a signal handler.
  void stop() { stopped_ = true; }
  bool is_stopped() const { return stopped_; }
  /// NotYet while rendering.
  RenderEnd end() const { return end_; }

  RenderProgress progress() const;
  RenderTotals totals() const;
  double seconds() const { return totals().seconds; }
  std::uint64_t ray_count() const { return totals().rays; }
  std::uint64_t path_count() const { return totals().paths; }
  double sampling_seconds() const { return totals().sampling_seconds; }
  std::uint64_t rejected_samples() const { return totals().rejected; }
  /// Finds why the first pixel with rejected samples has them, by drawing its samples again up to the first
  /// such one. An empty term: each term was finite, but their product was too large. To be called once `run`
  /// has returned; empty if there are no such samples.
  std::optional<NotFinite> cause_of_rejection() const;
  /// Lists what a sample of a pixel consists of, by sequence `scrambling` of the pixel, any number of which
  /// are independent, and returns the number of its rays. Needs no `run`; the integrator must be `Path`.
  std::uint64_t contributions_of(int x, int y, int scrambling, std::uint32_t number,
                                 std::vector<Contribution>& contributions) const;
  /// The mean over pixels.
  double samples_per_pixel() const;

  /// The image so far. Workers continue; each tile is in a consistent state.
  Snapshot snapshot(bool with_variance = false) const;
  /// The same for one tile.
  void copy_tile(int tile, FilmTile& copy) const;
  std::uint32_t sample_count_of(int tile) const;

  const RenderSettings& settings() const { return settings_; }

  /// Must be called once `run` has returned; before that, only sizes and bounds are valid.
  const Film& film() const { return film_; }
  /// Returns the film's error estimate with the bias of the settings, computed on their threads. To be called
  /// once `run` has returned.
  std::optional<ErrorEstimate> error_estimate() const;

  /// The error checks so far: of a render with a target error, or a probe.
  std::vector<ErrorCheck> checks() const;
  /// The part of the image's pixels that is rendered: less than 1 for a probe.
  double rendered_fraction() const;
  /// Forecasts the render of the whole image until each of these errors, without a limit of samples or time,
  /// in seconds of rendering from its start. Empty while too little is known. An error is left out if the
  /// bias of the settings is too large a part of it, so that its render would have another one.
  std::vector<TargetForecast> forecasts(const std::vector<double>& target_errors) const;

 private:
  RenderEnd run_stages();
  bool is_adaptive() const { return settings_.is_adaptive() && part_samples_.empty(); }
  void take_part();
  std::uint32_t first_sample(int tile, std::size_t half) const;
  double samples_wanted() const;
  int stage_from(int samples) const;
  std::vector<FilmTile::Counts> counts_at(int samples) const;
  bool exceeds(int samples) const;
  bool has_pilot() const;
  bool run_stage(int samples);
  RenderEnd check_error(int samples);
  void work(TileQueue& queue);
  bool render_tile(const TileWork& work, FilmTile& tile);
  void render_pixel(const TileWork& work, int x, int y, FilmTile& tile, RenderTotals& done,
                    RayCounter& counter) const;
  void keep_tile(const TileWork& work, const FilmTile& tile, const RenderTotals& done,
                 std::uint64_t sampling_ticks);
  Rgb sample(Kernel kernel, int crop_x, int crop_y, int scrambling, std::uint32_t number,
             RayCounter& counter) const;
  /// The position in the pixel (x, y), and that on the lens (z, w).
  Uniform4 place_in_pixel(int sample, PathSampler& sampler) const;
  std::optional<Rgb> backplate_at(float x, float y) const;
  bool ends_early();
  double elapsed() const;
  double render_clock() const;
  double pixel_count() const { return pixel_count_; }
  std::optional<Forecast> forecast() const;
  std::optional<RenderCost> cost() const;
  ForecastValue samples_needed(double samples) const;
  bool renders(int tile) const { return is_rendered_[static_cast<std::size_t>(tile)]; }

  /// The samples to the end, as forecast when there were so many.
  struct SamplesNeeded {
    double basis = 0;
    ForecastValue samples;
  };

  std::mutex& lock_of(int tile) const {
    return tile_locks_[static_cast<std::size_t>(tile) % tile_locks_.size()];
  }

  const CompiledScene& scene_;
  RenderSettings settings_;
  CropWindow crop_;  ///< the whole image if there is none
  Kernel kernel_;
  Camera camera_;
  Film film_;
  std::vector<TileSamples> part_samples_;              ///< by tile; empty unless a part is rendered
  std::vector<bool> is_rendered_;                      ///< by tile
  double pixel_count_ = 0;                             ///< of these tiles
  std::optional<AdaptiveSampling> adaptive_sampling_;  ///< set once the pilot is done
  /// Held while a tile of the film is copied or put back: for about a microsecond every few milliseconds.
  mutable std::array<std::mutex, 64> tile_locks_;
  const std::chrono::steady_clock::time_point start_;
  const std::uint64_t start_ticks_;
  const double start_process_seconds_;
  std::atomic<bool> stopped_ = false;
  std::atomic<bool> out_of_time_ = false;
  std::atomic<RenderEnd> end_ = RenderEnd::NotYet;

  mutable std::mutex totals_lock_;  ///< guards the members below
  RenderTotals totals_;             ///< seconds are those of earlier runs
  std::uint64_t restored_paths_ = 0;
  std::uint64_t sampling_ticks_ = 0;
  ErrorSums error_sums_;  ///< approximately the film's, in the order in which tiles were done
  std::vector<ErrorCheck> checks_;
  mutable std::optional<SamplesNeeded> needed_;
};

}  // namespace transport
