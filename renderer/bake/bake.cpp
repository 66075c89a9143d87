#include "renderer/bake/bake.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "renderer/image/image_error.h"
#include "renderer/parallel/loops.h"
#include "renderer/reflectance/schemes/own_scheme.h"
#include "renderer/transport/integrators/shading_point.h"
#include "renderer/transport/sobol.h"

namespace bake {
namespace {

using grf::Vec3f;
using transport::CompiledScene;
using transport::GatherSample;
using transport::IntegratorSettings;
using transport::RenderEnd;
using transport::RenderTotals;
using transport::ShadingPoint;

/// Pilot samples per half, which estimate the variance at a vertex.
constexpr int HalfPilotSamples = Bake::PilotSamples / 2;

/// Returns the number of samples at the next error check.
std::int64_t next_check(std::int64_t samples) {
  return samples + std::max<std::int64_t>(2, (samples / 5 + 1) / 2 * 2);
}

IntegratorSettings for_gathering(IntegratorSettings settings) {
  settings.integrator = transport::Integrator::Path;
  settings.resampling.reset();
  settings.uses_irradiance = false;
  settings.measures_sampling = false;
  return settings;
}

}  // namespace

/// A vertex to which a worker adds samples.
class Bake::Vertex {
 public:
  BakeTally tally;
  std::vector<transport::ExactRgbSum> sums;
  RenderTotals done;
  transport::RayCounter counter;
  reflectance::Frame frame{Vec3f(0, 0, 1)};

  void stand_at(std::size_t index, const BakePoints& points, const reflectance::Reflector& reflector) {
    points.points_at(index, points_);
    shading_points_.clear();
    for (const BakePoints::Point& at : points_) {
      shading_points_.emplace_back(at.point, reflector, at.point.geometric_normal);
    }
    frame = reflectance::Frame(BakePoints::normal_of(points_));
  }

  /// Selects one of the points with a probability equal to its fraction of the angles.
  const ShadingPoint& shading_point(float xi) const {
    const auto chosen = std::find_if(points_.begin(), points_.end() - 1, [&](const BakePoints::Point& at) {
      return xi < at.cumulative_fraction;
    });
    return shading_points_[static_cast<std::size_t>(chosen - points_.begin())];
  }

 private:
  std::vector<BakePoints::Point> points_;
  std::vector<ShadingPoint> shading_points_;
};

Bake::Bake(const CompiledScene& scene, const BakePoints& points, const BakeSettings& settings)
    : scene_(scene),
      points_(points),
      settings_(settings),
      kernel_(transport::gather_kernel_of(scene, for_gathering(settings.integrator))),
      white_(reflectance::Diffuse{grf::Colour(1)}, reflectance::OwnScheme()),
      cells_(std::max(1, settings.directions)),
      tallies_(points.count()),
      sums_(points.count() * sums_per_vertex()),
      samples_of_run_(settings.samples),
      start_(std::chrono::steady_clock::now()) {
  settings_.integrator = for_gathering(settings.integrator);
  for (std::size_t i = 0; i < points.count(); ++i) baked_vertices_ += points.has_faces(i) ? 1 : 0;
}

void Bake::restore(int stage, const RenderTotals& totals) {
  stage_ = stage;
  totals_ = totals;
  restored_paths_ = totals.paths;
}

void Bake::restore_vertex(std::size_t vertex, const BakeTally& tally,
                          const std::vector<transport::ExactRgbSum>& sums) {
  tallies_[vertex] = tally;
  std::copy(sums.begin(), sums.end(),
            sums_.begin() + static_cast<std::ptrdiff_t>(vertex * sums_per_vertex()));
}

void Bake::copy_vertex(std::size_t vertex, BakeTally& tally,
                       std::vector<transport::ExactRgbSum>& sums) const {
  const std::lock_guard lock(lock_of(vertex));
  tally = tallies_[vertex];
  const auto first = sums_.begin() + static_cast<std::ptrdiff_t>(vertex * sums_per_vertex());
  sums.assign(first, first + static_cast<std::ptrdiff_t>(sums_per_vertex()));
}

void Bake::put_back(std::size_t index, const Vertex& vertex) {
  {
    const std::lock_guard lock(lock_of(index));
    restore_vertex(index, vertex.tally, vertex.sums);
  }
  const std::lock_guard lock(totals_lock_);
  totals_.paths += vertex.done.paths;
  totals_.rays += vertex.counter.rays;
  totals_.rejected += vertex.done.rejected;
  if (vertex.done.rejected > 0) totals_.first_rejected = std::min(totals_.first_rejected, index);
}

void Bake::run() {
  RenderEnd end = RenderEnd::NotYet;
  parallel::run_with_threads(settings_.threads, [&] { end = run_stages(); });
  const RenderTotals all = totals();
  const std::lock_guard lock(totals_lock_);
  totals_ = all;
  end_ = end;
}

/// Samples per vertex at which the error is checked: at the end of the pilots, then at growing intervals, so
/// that a bake that time or a signal ends is about equally good everywhere.
int Bake::samples_of_stage(int stage) const {
  std::int64_t samples = PilotSamples;
  for (int i = 0; i < stage && samples < settings_.samples; ++i) samples = next_check(samples);
  return static_cast<int>(std::min<std::int64_t>(samples, settings_.samples));
}

bool Bake::has_pilot() const {
  for (std::size_t i = 0; i < tallies_.size(); ++i) {
    if (!points_.has_faces(i)) continue;
    for (int half = 0; half < 2; ++half) {
      const std::uint32_t count = count_after(tallies_[i], half, samples_of_stage(0));
      if (tallies_[i].counts[static_cast<std::size_t>(half)] < count) return false;
    }
  }
  return true;
}

RenderEnd Bake::run_part() {
  const bool is_after_pilot = has_pilot();
  const int samples = samples_of_stage(0);
  samples_of_run_ = double(is_after_pilot ? settings_.samples - samples : samples) / settings_.part->count;
  if (is_after_pilot) weigh_vertices();
  const bool is_done = run_stage(is_after_pilot ? settings_.samples : samples);
  if (is_done) return RenderEnd::Samples;
  return stopped_ ? RenderEnd::Stopped : RenderEnd::Time;
}

RenderEnd Bake::run_stages() {
  if (settings_.part) return run_part();
  // The checkpoint may have been written while the pilots were finishing.
  if (stage_ > 0 && !run_stage(samples_of_stage(0))) return stopped_ ? RenderEnd::Stopped : RenderEnd::Time;
  while (true) {
    const int samples = samples_of_stage(stage_);
    if (stage_ > 0) weigh_vertices();
    if (!run_stage(samples)) return stopped_ ? RenderEnd::Stopped : RenderEnd::Time;
    if (settings_.target_error && reaches_target()) return RenderEnd::TargetError;
    if (samples == settings_.samples) return RenderEnd::Samples;
    ++stage_;
  }
}

bool Bake::run_stage(int samples) {
  parallel::for_each_range(points_.count(), [&](std::size_t begin, std::size_t end) {
    Vertex vertex;
    for (std::size_t i = begin; i != end; ++i) {
      const bool is_own = points_.has_faces(i) && (!settings_.part || settings_.part->has(i));
      if (is_own && !advance(i, samples, vertex)) break;
    }
  });
  return !stopped_ && !out_of_time_;
}

bool Bake::reaches_target() {
  const auto error = estimated_error();
  const std::lock_guard lock(totals_lock_);
  last_error_ = error;
  return error && *error <= *settings_.target_error;
}

/// The standard deviation of a vertex's radiance, relative to the divisor of Film::estimated_error.
double Bake::deviation(const BakeTally& tally, int half) const {
  const BakeTally::Pilot& pilot = tally.pilots[static_cast<std::size_t>(half)];
  const double mean = pilot.sum / HalfPilotSamples;
  const double variance = std::max(0.0, pilot.squares / HalfPilotSamples - mean * mean);
  return std::sqrt(variance / (mean * mean + image::RelmseFloor));
}

// A pilot can miss rare events: each vertex counts with at least a quarter of the mean deviation.
void Bake::weigh_vertices() {
  const auto mean_of = [&](const auto& function) {
    double sum = 0;
    for (std::size_t i = 0; i < tallies_.size(); ++i) sum += points_.has_faces(i) ? function(tallies_[i]) : 0;
    return sum / baked_vertex_count();
  };
  for (int half = 0; half < 2; ++half) {
    Weighing& weighing = weighings_[static_cast<std::size_t>(half)];
    weighing.least = mean_of([&](const BakeTally& tally) { return deviation(tally, half); }) / 4;
    weighing.mean =
        mean_of([&](const BakeTally& tally) { return std::max(deviation(tally, half), weighing.least); });
  }
}

/// Returns the number of samples of a half at this mean number of samples per vertex.
std::uint32_t Bake::count_after(const BakeTally& tally, int half, int samples) const {
  const int mean_count = samples / 2 + (half == 0 ? samples % 2 : 0);
  if (mean_count <= HalfPilotSamples) return static_cast<std::uint32_t>(mean_count);
  const Weighing& weighing = weighings_[static_cast<std::size_t>(1 - half)];
  const double weight =
      weighing.mean > 0 ? std::max(deviation(tally, 1 - half), weighing.least) / weighing.mean : 1;
  const double count = HalfPilotSamples + std::floor((mean_count - HalfPilotSamples) * weight + 0.5);
  constexpr double Most = std::numeric_limits<std::uint32_t>::max();
  return static_cast<std::uint32_t>(std::min(count, Most));
}

/// Adds samples to a vertex that no other worker writes. False if that ended early; the samples so far are
/// kept.
bool Bake::advance(std::size_t index, int samples, Vertex& vertex) {
  if (ends_early()) return false;
  copy_vertex(index, vertex.tally, vertex.sums);
  const std::array<std::uint32_t, 2> counts = {count_after(vertex.tally, 0, samples),
                                               count_after(vertex.tally, 1, samples)};
  if (vertex.tally.counts[0] >= counts[0] && vertex.tally.counts[1] >= counts[1]) return true;
  vertex.done = {};
  vertex.counter = {};
  vertex.stand_at(index, points_, white_);
  const bool is_whole = add_samples(index, 0, counts[0], vertex) && add_samples(index, 1, counts[1], vertex);
  put_back(index, vertex);
  return is_whole;
}

bool Bake::add_samples(std::size_t index, int half, std::uint32_t count, Vertex& vertex) {
  const auto h = static_cast<std::size_t>(half);
  const std::uint32_t seed = transport::hash(
      transport::hash(settings_.seed, static_cast<std::uint32_t>(index)), static_cast<std::uint32_t>(half));
  for (std::uint32_t& number = vertex.tally.counts[h]; number < count; ++number) {
    if (number % 16 == 0 && ends_early()) return false;
    transport::PathSampler sampler(seed, number);
    const ShadingPoint& shading = vertex.shading_point(sampler.next().x);
    GatherSample gathered;
    if (settings_.integrator.depth > 0) {
      gathered = kernel_(scene_, settings_.integrator, shading, sampler, vertex.counter);
    }
    ++vertex.done.paths;
    const grf::Colour radiance = gathered.light.radiance + gathered.scattered.radiance;
    if (!transport::ExactRgbSum::can_add(gathered.light.radiance) ||
        !transport::ExactRgbSum::can_add(gathered.scattered.radiance)) {
      assert(transport::is_finite(radiance) && "a sample is not finite");
      ++vertex.done.rejected;
      continue;
    }
    add(gathered, half, vertex);
    if (number >= HalfPilotSamples) continue;
    const double mean = reflectance::mean(radiance);
    vertex.tally.pilots[h].sum += mean;
    vertex.tally.pilots[h].squares += mean * mean;
  }
  return true;
}

void Bake::add(const GatherSample& gathered, int half, Vertex& vertex) const {
  for (const transport::IncidentSample& arrival : {gathered.light, gathered.scattered}) {
    if (arrival.radiance == grf::Colour(0)) continue;
    const std::size_t cell =
        cell_count() == 1
            ? 0
            : static_cast<std::size_t>(cells_.cell_of(vertex.frame.to_local(arrival.direction)));
    vertex.sums[static_cast<std::size_t>(half) * cell_count() + cell].add(arrival.radiance);
  }
}

bool Bake::ends_early() {
  if (settings_.max_seconds && elapsed() >= *settings_.max_seconds) out_of_time_ = true;
  return stopped_ || out_of_time_;
}

double Bake::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

RenderTotals Bake::totals() const {
  const std::lock_guard lock(totals_lock_);
  RenderTotals totals = totals_;
  if (end_ == RenderEnd::NotYet) totals.seconds += elapsed();
  return totals;
}

double Bake::samples_per_vertex() const { return static_cast<double>(totals().paths) / baked_vertex_count(); }

transport::RenderProgress Bake::progress() const {
  transport::RenderProgress progress;
  progress.seconds = totals().seconds;
  const double samples = samples_per_vertex();
  double needed = samples_of_run_;
  double restored = 0;
  {
    const std::lock_guard lock(totals_lock_);
    progress.estimated_error = last_error_;
    restored = static_cast<double>(restored_paths_) / baked_vertex_count();
  }
  const RenderEnd end = end_;
  if (end != RenderEnd::NotYet && end != RenderEnd::Stopped) {
    progress.done = 1;
    progress.seconds_left = 0;
    return progress;
  }
  if (settings_.target_error && progress.estimated_error) {
    // Extrapolates from the last error check with the convergence of independent samples.
    const double ratio = std::max(1.0, *progress.estimated_error / *settings_.target_error);
    needed = std::min(needed, std::max(samples, samples_of_stage(stage_) / 1.2 * ratio * ratio));
  }
  progress.done = std::min(1.0, samples / needed);
  if (samples > restored && needed < transport::RenderSettings::Unlimited) {
    progress.seconds_left = std::max(0.0, needed - samples) * elapsed() / (samples - restored);
  }
  if (settings_.max_seconds && end == RenderEnd::NotYet) {
    const double left = std::max(0.0, *settings_.max_seconds - elapsed());
    progress.seconds_left = std::min(left, progress.seconds_left.value_or(left));
    progress.done = std::clamp(elapsed() / *settings_.max_seconds, progress.done, 1.0);
  }
  return progress;
}

std::size_t Bake::value_count() const {
  return static_cast<std::size_t>(std::count_if(tallies_.begin(), tallies_.end(),
                                                [](const BakeTally& tally) { return tally.counts[0] > 0; }));
}

Imath::V3d Bake::radiance(std::size_t vertex, int half, std::size_t cell) const {
  const std::uint32_t count = tallies_[vertex].counts[static_cast<std::size_t>(half)];
  const std::size_t index = vertex * sums_per_vertex() + static_cast<std::size_t>(half) * cell_count() + cell;
  return count == 0 ? Imath::V3d(0) : sums_[index].value() / count;
}

Imath::V3d Bake::radiance(std::size_t vertex, int half) const {
  Imath::V3d sum(0);
  for (std::size_t cell = 0; cell < cell_count(); ++cell) sum += radiance(vertex, half, cell);
  return sum;
}

// The mean of the halves' means, not of all samples: a half's sample count depends on the other half's
// values.
grf::Colour Bake::irradiance(std::size_t vertex, int cell) const {
  const auto index = static_cast<std::size_t>(cell);
  const double halves = tallies_[vertex].counts[1] > 0 ? 2 : 1;
  return grf::Colour((radiance(vertex, 0, index) + radiance(vertex, 1, index)) * (std::numbers::pi / halves));
}

grf::Colour Bake::irradiance(std::size_t vertex) const {
  const double halves = tallies_[vertex].counts[1] > 0 ? 2 : 1;
  return grf::Colour((radiance(vertex, 0) + radiance(vertex, 1)) * (std::numbers::pi / halves));
}

std::vector<Vec3f> Bake::directions(std::size_t vertex) const {
  std::vector<BakePoints::Point> points;
  points_.points_at(vertex, points);
  const reflectance::Frame frame(BakePoints::normal_of(points));
  std::vector<Vec3f> directions;
  for (int cell = 0; cell < cells_.count(); ++cell) {
    directions.push_back(frame.to_world(cells_.centre(cell)));
  }
  return directions;
}

std::optional<double> Bake::estimated_error() const {
  double sum = 0;
  std::size_t counted = 0;
  for (std::size_t i = 0; i < tallies_.size(); ++i) {
    if (tallies_[i].counts[1] == 0) continue;
    const Imath::V3d a = radiance(i, 0);
    const Imath::V3d b = radiance(i, 1);
    for (int k = 0; k < 3; ++k) {
      const double mean = (a[k] + b[k]) / 2;
      sum += (a[k] - b[k]) * (a[k] - b[k]) / 4 / (mean * mean + image::RelmseFloor);
    }
    counted += 3;
  }
  if (counted == 0) return std::nullopt;
  return std::sqrt(sum / static_cast<double>(counted));
}

}  // namespace bake
