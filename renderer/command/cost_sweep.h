// Many renders of one scene, and how far each is from a reference.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "renderer/transport/image/image.h"
#include "renderer/transport/image/image_error.h"
#include "renderer/transport/render.h"

namespace command {

/// What is rendered of a line.
struct CostSubject {
  std::shared_ptr<const transport::CompiledScene> scene;
  /// But for samples and seed. Of `naive`, `samples` are the rays from the eye for a pixel.
  transport::RenderSettings settings;
};

struct CostPlan {
  std::vector<CostSubject> lines;
  std::vector<int> samples;               ///< a pixel; of `naive`, paths: a multiple of the rays from the eye
  std::optional<transport::Image> given;  ///< the reference, if it is not to be rendered
  CostSubject reference;                  ///< what to render for it
  int reference_samples = 0;
  int rounds = 1;  ///< in which each row is rendered, each time with another seed
  std::uint32_t seed = 0;
};

struct CostReference {
  transport::Image image;
  double seconds = 0;
  double relmse = 0;  ///< its own, as its two halves say; 0 if it was given
};

/// What was measured of one line at one number of samples.
struct CostRow {
  std::size_t line = 0;
  int samples = 0;
  std::vector<std::uint32_t> seeds;                   ///< of the rounds so far
  double render_seconds = 0;                          ///< the least of the rounds: what others do only adds
  double sampling_seconds = 0;                        ///< of all threads together, see `CostSweep`
  double relmse = 0;                                  ///< the mean of the rounds
  std::optional<double> average_relative_error = {};  ///< likewise; nothing if the reference is black

  double error() const;       ///< sqrt(relMSE)
  double efficiency() const;  ///< 1 / (relMSE x render seconds)
};

/// Renders each line at each number of samples afresh, round after round, so that what else the machine does
/// meets all of them alike.
///
/// Before that, each line is rendered once at the middle number of samples: that warms it up, and measures
/// the time in which directions are drawn, which reading the clock makes slower. The rows' sampling seconds
/// are in proportion to that.
class CostSweep {
 public:
  /// At least one line and one number of samples.
  explicit CostSweep(CostPlan plan);

  /// Called once. Throws what a render throws.
  void run();
  /// Has `run` return soon, with what there is; from any thread.
  void stop();

  transport::RenderProgress progress() const;

  // Once `run` has returned.

  /// Those that were rendered at least once, line by line.
  std::vector<CostRow> rows() const;
  /// Nothing if it came to an early end.
  const std::optional<CostReference>& reference() const { return reference_; }

 private:
  enum class Purpose { WarmUp, Reference, Row };
  struct Piece {
    Purpose purpose = Purpose::Row;
    std::size_t subject = 0;  ///< the last one is the reference
    int samples = 0;
    std::size_t row = 0;
  };

  void plan_pieces();
  const CostSubject& subject(std::size_t index) const;
  bool render(const Piece& piece);
  void keep(const Piece& piece, const transport::Render& render);
  void add_to_row(const transport::Render& render, CostRow& row);

  CostPlan plan_;
  std::vector<Piece> pieces_;
  std::vector<CostRow> rows_;
  std::vector<double> sampling_rates_;  ///< seconds a sample of a pixel
  std::optional<CostReference> reference_;
  const std::chrono::steady_clock::time_point start_;

  mutable std::mutex lock_;    ///< of what follows
  std::vector<double> rates_;  ///< seconds a sample of a pixel, of each subject
  std::size_t next_ = 0;       ///< the piece that is rendered
  transport::Render* current_ = nullptr;
  bool is_stopped_ = false;
};

}  // namespace command
