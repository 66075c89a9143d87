#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "renderer/bake/bake_points.h"
#include "renderer/bake/hemisphere_cells.h"
#include "renderer/reflectance/reflector.h"
#include "renderer/transport/exact_sum.h"
#include "renderer/transport/render.h"

namespace bake {

/// A part of the vertices of a bake: each `count`-th one, from number `index` on.
struct BakePart {
  std::uint32_t index = 0;
  std::uint32_t count = 1;

  bool operator==(const BakePart&) const = default;
  bool has(std::size_t vertex) const { return vertex % count == index; }
};

struct BakeSettings {
  /// Path integrator settings. The scattering at a vertex counts as one bounce of the depth, so a render of
  /// the same depth shows the same with and without irradiance.
  transport::IntegratorSettings integrator;
  int samples = 100;                   ///< samples per vertex: the mean over vertices, at most
  std::optional<double> target_error;  ///< stops once Bake::estimated_error is at most this
  std::optional<double> max_seconds;   ///< stops after this time, with the samples so far
  int directions = 0;                  ///< hemisphere cells, each with its own value; 0: one value for all
  std::uint32_t seed = 0;
  int threads = 0;  ///< 0: one per core
  /// Bakes only these vertices, to the number of samples: their pilot, or if the pilot of all vertices was
  /// restored, the rest.
  std::optional<BakePart> part;
};

/// The state of a vertex, besides its sums.
struct BakeTally {
  /// Sums over the pilot samples of one half.
  struct Pilot {
    double sum = 0;
    double squares = 0;
  };

  std::array<std::uint32_t, 2> counts = {};
  std::array<Pilot, 2> pilots = {};
};

/// Bakes the irradiance at the vertices of a scene. `run` is called once; the functions above `irradiance`
/// may be called from any thread meanwhile.
///
/// A sample is a path that starts with a bounce off a white diffuse surface at the vertex; its radiance times
/// pi estimates the irradiance. Each vertex has two halves of samples with independent scramblings: its value
/// is the mean of theirs, and their difference gives the error. The first samples of a half, the same number
/// at all vertices, are a pilot that places the samples of the other half: in proportion to relative standard
/// deviation, which minimises the error for a given number of samples. As no half decides its own sample
/// counts, no value is biased.
class Bake {
 public:
  /// Samples per vertex of the pilot.
  static constexpr int PilotSamples = 64;

  /// The scene must be compiled `without_instances`. The scene and the points must outlive the bake.
  Bake(const transport::CompiledScene& scene, const BakePoints& points, const BakeSettings& settings);

  /// Runs to the same end conditions as a render. The result depends only on the settings, unless time or
  /// `stop` ended it.
  void run();
  /// Safe to call from any thread.
  void stop() { stopped_ = true; }
  transport::RenderEnd end() const { return end_; }

  transport::RenderProgress progress() const;
  transport::RenderTotals totals() const;

  /// Copies what a checkpoint stores of a vertex: a consistent state from some moment of the run.
  void copy_vertex(std::size_t vertex, BakeTally& tally, std::vector<transport::ExactRgbSum>& sums) const;
  std::size_t sums_per_vertex() const { return 2 * cell_count(); }
  int stage() const { return stage_; }
  const BakeSettings& settings() const { return settings_; }
  std::size_t vertex_count() const { return points_.count(); }
  /// The number of vertices that means are over: those with faces around them, at least 1.
  double baked_vertex_count() const { return static_cast<double>(std::max<std::size_t>(1, baked_vertices_)); }

  /// Whether all vertices that have faces have their pilot.
  bool has_pilot() const;

  /// Resumes from the state of another bake of the same scene; to be called before `run`.
  void restore(int stage, const transport::RenderTotals& totals);
  void restore_vertex(std::size_t vertex, const BakeTally& tally,
                      const std::vector<transport::ExactRgbSum>& sums);

  // Once `run` has returned:

  /// Whether a vertex has a value: false if it has no faces around it, or no sample yet.
  bool has_value(std::size_t vertex) const { return tallies_[vertex].counts[0] > 0; }
  std::size_t value_count() const;
  /// Irradiance in W/m2, over all directions or over one cell.
  grf::Colour irradiance(std::size_t vertex) const;
  grf::Colour irradiance(std::size_t vertex, int cell) const;
  /// The unit directions of the cells' centres, in world space.
  std::vector<grf::Vec3f> directions(std::size_t vertex) const;
  /// sqrt(relMSE) over vertices and channels, of the radiance of a white diffuse surface; compare
  /// Film::estimated_error over pixels. Empty while there are no two halves.
  std::optional<double> estimated_error() const;
  double samples_per_vertex() const;

 private:
  class Vertex;

  std::size_t cell_count() const { return static_cast<std::size_t>(cells_.count()); }
  transport::RenderEnd run_stages();
  transport::RenderEnd run_part();
  int samples_of_stage(int stage) const;
  bool run_stage(int samples);
  bool reaches_target();
  void weigh_vertices();
  double deviation(const BakeTally& tally, int half) const;
  std::uint32_t count_after(const BakeTally& tally, int half, int samples) const;
  bool advance(std::size_t index, int samples, Vertex& vertex);
  bool add_samples(std::size_t index, int half, std::uint32_t count, Vertex& vertex);
  void add(const transport::GatherSample& gathered, int half, Vertex& vertex) const;
  void put_back(std::size_t index, const Vertex& vertex);
  Imath::V3d radiance(std::size_t vertex, int half) const;
  Imath::V3d radiance(std::size_t vertex, int half, std::size_t cell) const;
  bool ends_early();
  double elapsed() const;

  std::mutex& lock_of(std::size_t vertex) const { return vertex_locks_[vertex % vertex_locks_.size()]; }

  const transport::CompiledScene& scene_;
  const BakePoints& points_;
  BakeSettings settings_;
  transport::GatherKernel kernel_;
  const reflectance::Reflector white_;
  HemisphereCells cells_;
  std::size_t baked_vertices_ = 0;  ///< vertices that have faces
  std::vector<BakeTally> tallies_;
  std::vector<transport::ExactRgbSum> sums_;  ///< per vertex, half and cell; the cell varies fastest
  /// Pilot statistics of a half: the smallest deviation that counts, and the mean of the deviations.
  struct Weighing {
    double least = 0;
    double mean = 0;
  };
  std::array<Weighing, 2> weighings_;
  mutable std::array<std::mutex, 64> vertex_locks_;
  std::atomic<double> samples_of_run_;  ///< mean over all vertices, when the run is done
  const std::chrono::steady_clock::time_point start_;
  std::atomic<int> stage_ = 0;
  std::atomic<bool> stopped_ = false;
  std::atomic<bool> out_of_time_ = false;
  std::atomic<transport::RenderEnd> end_ = transport::RenderEnd::NotYet;

  mutable std::mutex totals_lock_;  ///< guards the members below
  transport::RenderTotals totals_;  ///< seconds are those of earlier runs
  std::uint64_t restored_paths_ = 0;
  std::optional<double> last_error_;
};

}  // namespace bake
