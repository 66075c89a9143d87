// A cost sweep renders one scene many times and measures each image's error against a reference.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "renderer/command/cost_efficiency.h"
#include "renderer/image/image.h"
#include "renderer/image/image_error.h"
#include "renderer/transport/render.h"

namespace command {

/// The compiled scene and settings of a line.
struct CostSubject {
  std::shared_ptr<const transport::CompiledScene> scene;
  /// All but samples and seed. For `naive`, `samples` are the camera rays per pixel.
  transport::RenderSettings settings;
};

struct CostReference {
  image::Image image;
  double seconds = 0;
  double relmse = 0;  ///< its own relMSE, estimated from its two halves; 0 if it was given
};

/// The measurements of one line at one sample count.
struct CostRow {
  std::size_t line = 0;
  int samples = 0;
  std::vector<std::uint32_t> seeds;                   ///< of the rounds so far
  double render_seconds = 0;                          ///< minimum over rounds: other load only adds time
  double sampling_seconds = 0;                        ///< sum over threads, see `CostSweep`
  double relmse = 0;                                  ///< mean over rounds
  std::optional<double> average_relative_error = {};  ///< likewise; nothing if the reference is black
  std::vector<CostRound> rounds = {};                 ///< one per seed

  double error() const;       ///< sqrt(relMSE)
  double efficiency() const;  ///< 1 / (relMSE x render seconds)
};

struct CostPlan {
  std::vector<CostSubject> lines;
  std::vector<int> samples;            ///< per pixel; for `naive`, paths: a multiple of the camera rays
  std::optional<CostReference> given;  ///< the reference, if it is not to be rendered
  std::vector<CostRow> known;          ///< rows of an earlier study, of which missing rounds are rendered
  CostSubject reference;               ///< renders the reference image
  int reference_samples = 0;
  int rounds = 1;  ///< renders per row, each with another seed
  std::uint32_t seed = 0;
};

/// Renders each line at each sample count afresh, round after round, so that other load on the machine
/// affects all rows alike.
///
/// Before that, each line is rendered once at the median sample count. This warm-up also measures the time
/// spent sampling directions, which reading the clock makes slower; the rows' sampling seconds are scaled
/// from it.
class CostSweep {
 public:
  /// The plan needs at least one line and one sample count.
  explicit CostSweep(CostPlan plan);

  /// Runs the sweep, once. Throws what a render throws.
  void run();
  /// Makes `run` return soon with the rows so far; from any thread.
  void stop();

  transport::RenderProgress progress() const;

  /// Returns the rows that were rendered at least once, line by line; from any thread.
  std::vector<CostRow> rows() const;
  /// Returns the number of renders that `rows` have, without those of an earlier study; from any thread.
  std::size_t measured() const;

  /// Returns the reference; nothing if it was not rendered yet. It stays once `measured` is over 0, and is
  /// valid after `run` has returned.
  const std::optional<CostReference>& reference() const { return reference_; }

 private:
  enum class Purpose { WarmUp, Reference, Row };
  struct Task {
    Purpose purpose = Purpose::Row;
    std::size_t subject = 0;  ///< index of a line; the last index is the reference
    int samples = 0;
    std::size_t row = 0;
  };

  void plan_tasks();
  const CostSubject& subject(std::size_t index) const;
  bool render(const Task& task);
  void keep(const Task& task, const transport::Render& render);
  void add_known_rows();
  std::uint32_t seed_of(const Task& task) const;
  void add_to_row(const transport::Render& render, CostRow& row);

  CostPlan plan_;
  std::vector<Task> tasks_;
  std::vector<double> sampling_rates_;  ///< sampling seconds per sample per pixel, of each subject
  std::optional<CostReference> reference_;
  const std::chrono::steady_clock::time_point start_;

  mutable std::mutex lock_;    ///< guards the members below
  std::vector<double> rates_;  ///< render seconds per sample per pixel, of each subject
  std::vector<CostRow> rows_;
  std::size_t measured_ = 0;
  std::size_t next_ = 0;  ///< index of the current task
  transport::Render* current_ = nullptr;
  bool is_stopped_ = false;
};

}  // namespace command
