#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "renderer/reflectance/reflector.h"
#include "renderer/transport/bake_points.h"
#include "renderer/transport/hemisphere_cells.h"
#include "renderer/transport/render.h"

namespace transport {

struct BakeSettings {
  /// Of the path integrator. The scattering at a vertex is one of its depth, so that a render of the same
  /// depth shows what it would without irradiance.
  IntegratorSettings integrator;
  int samples = 100;                   ///< a vertex on average, at most
  std::optional<double> target_error;  ///< stops once Bake::estimated_error is no more than this
  std::optional<double> max_seconds;   ///< stops after so long, with what there is
  int directions = 0;                  ///< cells of the hemisphere with a value each; 0: one value for all
  std::uint32_t seed = 0;
  int threads = 0;  ///< 0: as many as the machine has
};

/// What a vertex has so far, besides its sums.
struct BakeTally {
  /// Of the first samples of one half.
  struct Pilot {
    double sum = 0;
    double squares = 0;
  };

  std::array<std::uint32_t, 2> counts = {};
  std::array<Pilot, 2> pilots = {};
};

/// The irradiance of the vertices of a scene. `run` is called once; the functions above `irradiance` may be
/// called from any thread meanwhile.
///
/// A sample is a path that starts with the scattering at a white matte surface in the vertex's place, whose
/// radiance times pi is the irradiance. Each vertex has two halves of samples, of independent scramblings,
/// and its value is the mean of theirs; how far they are apart gives the error. The first samples of a half,
/// of which all vertices have as many, say where those of the other half are to go: in proportion to the
/// deviation over the value, which makes the error least for a number of samples. So neither half's samples
/// decide where its own are, and no value is biased.
class Bake {
 public:
  /// The scene must be compiled `without_instances`; the points and what they are of outlive the bake.
  Bake(const CompiledScene& scene, const BakePoints& points, const BakeSettings& settings);

  /// Ends as a render does. The result depends on the settings alone, unless time or `stop` ended it.
  void run();
  /// Safe to call from any thread.
  void stop() { stopped_ = true; }
  RenderEnd end() const { return end_; }

  RenderProgress progress() const;
  RenderTotals totals() const;

  /// What a checkpoint holds: of a vertex, as some moment left it.
  void copy_vertex(std::size_t vertex, BakeTally& tally, std::vector<Imath::V3d>& sums) const;
  std::size_t sums_per_vertex() const { return 2 * cell_count(); }
  int stage() const { return stage_; }
  const BakeSettings& settings() const { return settings_; }
  std::size_t vertex_count() const { return points_.count(); }
  /// Of vertices with faces around them, 1 at least: what means are over.
  double baked_vertex_count() const { return static_cast<double>(std::max<std::size_t>(1, baked_vertices_)); }

  /// Takes up what another bake of the same scene had; to be called before `run`.
  void restore(int stage, const RenderTotals& totals);
  void restore_vertex(std::size_t vertex, const BakeTally& tally, const std::vector<Imath::V3d>& sums);

  // Once `run` has returned:

  /// Whether there is a value for a vertex: not without faces around it, nor before its first sample.
  bool has_value(std::size_t vertex) const { return tallies_[vertex].counts[0] > 0; }
  std::size_t value_count() const;
  /// W/m2, of all directions or of one cell.
  Rgb irradiance(std::size_t vertex) const;
  Rgb irradiance(std::size_t vertex, int cell) const;
  /// Where the middle of each cell is, unit, in the world.
  std::vector<Vec3f> directions(std::size_t vertex) const;
  /// sqrt(relMSE) over vertices and channels, of the radiance of a white matte surface, as
  /// Film::estimated_error is over pixels; nothing while there are no two halves.
  std::optional<double> estimated_error() const;
  double samples_per_vertex() const;

 private:
  class Vertex;

  std::size_t cell_count() const { return static_cast<std::size_t>(cells_.count()); }
  RenderEnd run_stages();
  int samples_of_stage(int stage) const;
  bool run_stage(int samples);
  bool reaches_target();
  void weigh_vertices();
  double deviation(const BakeTally& tally, int half) const;
  std::uint32_t count_after(const BakeTally& tally, int half, int samples) const;
  bool advance(std::size_t index, int samples, Vertex& vertex);
  bool add_samples(std::size_t index, int half, std::uint32_t count, Vertex& vertex);
  void add(const Gathered& gathered, int half, Vertex& vertex) const;
  void put_back(std::size_t index, const Vertex& vertex);
  Imath::V3d radiance(std::size_t vertex, int half) const;
  Imath::V3d radiance(std::size_t vertex, int half, std::size_t cell) const;
  bool ends_early();
  double elapsed() const;

  std::mutex& lock_of(std::size_t vertex) const { return vertex_locks_[vertex % vertex_locks_.size()]; }

  const CompiledScene& scene_;
  const BakePoints& points_;
  BakeSettings settings_;
  GatherKernel kernel_;
  const reflectance::Reflector white_;
  HemisphereCells cells_;
  std::size_t baked_vertices_ = 0;  ///< those that have faces
  std::vector<BakeTally> tallies_;
  std::vector<Imath::V3d> sums_;  ///< of vertex, half and cell, the last changing fastest
  /// Of the deviation that the pilot of a half shows: what counts at least, and the mean of what counts.
  struct Weighing {
    double least = 0;
    double mean = 0;
  };
  std::array<Weighing, 2> weighings_;
  mutable std::array<std::mutex, 64> vertex_locks_;
  const std::chrono::steady_clock::time_point start_;
  std::atomic<int> stage_ = 0;
  std::atomic<bool> stopped_ = false;
  std::atomic<bool> out_of_time_ = false;
  std::atomic<RenderEnd> end_ = RenderEnd::NotYet;

  mutable std::mutex totals_lock_;  ///< of what follows
  RenderTotals totals_;             ///< seconds are those of earlier runs
  std::uint64_t restored_paths_ = 0;
  std::optional<double> last_error_;
};

}  // namespace transport
