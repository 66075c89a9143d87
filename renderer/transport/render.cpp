#include "renderer/transport/render.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "renderer/transport/processor_clock.h"
#include "renderer/transport/thread_sanitizer.h"
#include "renderer/transport/threads.h"

namespace transport {
namespace {

static_assert(std::atomic<bool>::is_always_lock_free, "Render::stop is called from signal handlers");

/// The first number of samples that is not less, at which the error is looked at.
int check_from(int samples) {
  std::int64_t check = 16;
  while (check < samples) check += std::max<std::int64_t>(2, (check / 5 + 1) / 2 * 2);
  return static_cast<int>(std::min<std::int64_t>(check, RenderSettings::Unlimited));
}

FilmTile::Counts counts_after(int samples) {
  const auto count = static_cast<std::uint32_t>(samples);
  static_assert(Film::Scramblings == 2);
  return {count - count / 2, count / 2};
}

}  // namespace

Render::Render(const CompiledScene& scene, const RenderSettings& settings)
    : scene_(scene),
      settings_(settings),
      kernel_(kernel_of(scene, settings.integrator)),
      camera_(seen_from(scene.origin(), settings.view), settings.width, settings.height),
      film_(settings.width, settings.height),
      start_(std::chrono::steady_clock::now()),
      start_ticks_(processor_ticks()) {}

void Render::restore(const RenderTotals& totals) {
  totals_ = totals;
  restored_paths_ = totals.paths;
}

void Render::restore_tile(int tile, const FilmTile& sums) {
  film_.put_back(tile, sums);
  if (const auto error = sums.error_sum()) {
    error_sum_ += *error;
    error_values_ += 3 * static_cast<double>(sums.bounds.pixel_count());
  }
}

void Render::run() {
  RenderEnd end = RenderEnd::NotYet;
  run_with_threads(settings_.threads, [&] { end = run_stages(); });
  const RenderTotals all = totals();
  const std::lock_guard lock(totals_lock_);
  totals_ = all;
  end_ = end;
}

RenderEnd Render::run_stages() {
  std::uint32_t present = 0;
  for (int tile = 0; tile < film_.tile_count(); ++tile) {
    present = std::max(present, film_.sample_count_of(tile));
  }
  for (int samples = static_cast<int>(present);; ++samples) {
    samples = settings_.target_error ? std::min(check_from(samples), settings_.samples) : settings_.samples;
    if (!run_stage(samples)) return stopped_ ? RenderEnd::Stopped : RenderEnd::Time;
    if (settings_.target_error && reaches_target(samples)) return RenderEnd::TargetError;
    if (samples == settings_.samples) return RenderEnd::Samples;
  }
}

/// Gives all pixels so many samples; false if that came to an early end.
bool Render::run_stage(int samples) {
  const int threads = tbb::this_task_arena::max_concurrency();
  TileQueue queue(film_, samples, threads);
  publish();
  tbb::parallel_for(
      tbb::blocked_range<int>(0, threads, 1),
      [&](const tbb::blocked_range<int>& workers) {
        see();
        for (int i = workers.begin(); i != workers.end(); ++i) work(queue);
        publish();
      },
      tbb::simple_partitioner());
  see();
  return queue.is_finished();
}

bool Render::reaches_target(int samples) {
  const auto error = film_.estimated_error();
  if (!error) return false;
  const std::lock_guard lock(totals_lock_);
  checks_.push_back({static_cast<double>(samples), *error});
  return *error <= *settings_.target_error;
}

void Render::work(TileQueue& queue) try {
  FilmTile tile;
  while (!ends_early()) {
    const auto piece = queue.take();
    if (!piece || !render_tile(*piece, tile)) return;
    queue.done(*piece);
  }
} catch (...) {
  stop();  // the others need not go on
  throw;
}

/// Adds samples to a tile that nobody else writes. False if that came to an early end: the tile then stays as
/// it was, so that its pixels always have as many samples.
bool Render::render_tile(const TileWork& work, FilmTile& tile) {
  film_.copy_tile(work.tile, tile);
  RenderTotals done;
  RayCounter counter;
  for (int y = 0; y < tile.bounds.height; ++y) {
    if (ends_early()) return false;
    for (int x = 0; x < tile.bounds.width; ++x) {
      for (int number = work.first; number < work.last; ++number) {
        const int image_x = tile.bounds.x + x;
        const int image_y = tile.bounds.y + y;
        if (tile.add(x, y, number % Film::Scramblings, sample(image_x, image_y, number, counter))) continue;
        assert(false && "a sample is not finite");
        ++done.rejected;
        const auto index = static_cast<std::uint64_t>(image_y) * settings_.width + image_x;
        done.first_rejected = std::min(done.first_rejected, index);
      }
    }
  }
  tile.counts = counts_after(work.last);
  done.paths = tile.bounds.pixel_count() * static_cast<std::uint64_t>(work.last - work.first);
  done.rays = counter.rays;
  keep_tile(work, tile, done, counter.sampling_ticks);
  return true;
}

void Render::keep_tile(const TileWork& work, const FilmTile& tile, const RenderTotals& done,
                       std::uint64_t sampling_ticks) {
  const bool had_error = film_.counts_of(work.tile)[1] > 0;
  const double error_before = film_.error_sum_of(work.tile);
  {
    const std::lock_guard lock(lock_of(work.tile));
    film_.put_back(work.tile, tile);
  }
  const std::lock_guard lock(totals_lock_);
  totals_.paths += done.paths;
  totals_.rays += done.rays;
  totals_.rejected += done.rejected;
  totals_.first_rejected = std::min(totals_.first_rejected, done.first_rejected);
  sampling_ticks_ += sampling_ticks;
  error_sum_ += film_.error_sum_of(work.tile) - error_before;
  if (!had_error && tile.counts[1] > 0) error_values_ += 3 * static_cast<double>(tile.bounds.pixel_count());
}

// Samples alternate between the scramblings, each of which takes the points of its own sequence in order.
Rgb Render::sample(int x, int y, int number, RayCounter& counter) const {
  const std::uint32_t pixel_seed =
      hash(hash(settings_.seed, static_cast<std::uint32_t>(x)), static_cast<std::uint32_t>(y));
  PathNumbers numbers(hash(pixel_seed, static_cast<std::uint32_t>(number % Film::Scramblings)),
                      static_cast<std::uint32_t>(number / Film::Scramblings), settings_.points);
  const grf::Vec2f place = place_in_pixel(number, numbers);
  const float image_x = static_cast<float>(x) + place.x;
  const float image_y = static_cast<float>(y) + place.y;
  return kernel_(scene_, settings_.integrator, camera_.ray(image_x, image_y), behind(image_x, image_y),
                 numbers, counter);
}

grf::Vec2f Render::place_in_pixel(int sample, PathNumbers& numbers) const {
  switch (settings_.placing) {
    case PixelPlacing::Centre:
      return {0.5F, 0.5F};
    case PixelPlacing::Regular: {
      const int columns = settings_.grid_columns;
      const int rows = (settings_.samples + columns - 1) / columns;
      const auto middle = [](int cell, int count) {
        return (static_cast<float>(cell) + 0.5F) / static_cast<float>(count);
      };
      return {middle(sample % columns, columns), middle(sample / columns, rows)};
    }
    case PixelPlacing::Sobol:
      break;
  }
  return numbers.next().xy();
}

std::optional<Rgb> Render::behind(float x, float y) const {
  if (!settings_.backplate) return std::nullopt;
  const auto index_of = [](float place, int size, int count) {
    return std::min(static_cast<int>(place / static_cast<float>(size) * static_cast<float>(count)),
                    count - 1);
  };
  const Image& plate = *settings_.backplate;
  return plate.at(index_of(x, settings_.width, plate.width), index_of(y, settings_.height, plate.height));
}

bool Render::ends_early() {
  if (settings_.max_seconds && elapsed() >= *settings_.max_seconds) out_of_time_ = true;
  return stopped_ || out_of_time_;
}

double Render::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

double Render::pixel_count() const { return static_cast<double>(settings_.width) * settings_.height; }

RenderTotals Render::totals() const {
  const std::lock_guard lock(totals_lock_);
  RenderTotals totals = totals_;
  if (end_ != RenderEnd::NotYet) return totals;
  const double seconds = elapsed();
  const double ticks_per_second = static_cast<double>(processor_ticks() - start_ticks_) / seconds;
  totals.seconds += seconds;
  totals.sampling_seconds += static_cast<double>(sampling_ticks_) / ticks_per_second;
  return totals;
}

double Render::samples_per_pixel() const { return static_cast<double>(totals().paths) / pixel_count(); }

/// The exponent with which the error falls: that which the checks show, else that of independent samples.
double Render::convergence() const {
  const std::lock_guard lock(totals_lock_);
  if (checks_.empty()) return 0.5;
  const Check& last = checks_.back();
  const auto early = std::find_if(checks_.rbegin(), checks_.rend(),
                                  [&](const Check& check) { return 2 * check.samples <= last.samples; });
  if (early == checks_.rend() || !(early->error > 0) || !(last.error > 0)) return 0.5;
  return std::clamp(std::log(early->error / last.error) / std::log(last.samples / early->samples), 0.5, 1.0);
}

/// To the target or the last sample, whichever comes first.
double Render::samples_needed(double samples, std::optional<double> error) const {
  if (!settings_.target_error || !error) return settings_.samples;
  const double ratio = std::max(1.0, *error / *settings_.target_error);
  return std::min<double>(settings_.samples, samples * std::pow(ratio, 1 / convergence()));
}

RenderProgress Render::progress() const {
  const RenderTotals totals = this->totals();
  RenderProgress progress;
  progress.seconds = totals.seconds;
  double restored = 0;
  {
    const std::lock_guard lock(totals_lock_);
    restored = static_cast<double>(restored_paths_) / pixel_count();
    if (error_values_ > 0) progress.estimated_error = std::sqrt(std::max(0.0, error_sum_) / error_values_);
  }
  const RenderEnd end = end_;
  if (end != RenderEnd::NotYet && end != RenderEnd::Stopped) {
    progress.done = 1;
    progress.seconds_left = 0;
    return progress;
  }
  const double samples = static_cast<double>(totals.paths) / pixel_count();
  const double needed = samples_needed(samples, progress.estimated_error);
  progress.done = std::min(1.0, samples / needed);
  if (samples > restored && needed < RenderSettings::Unlimited) {
    progress.seconds_left = (needed - samples) * elapsed() / (samples - restored);
  }
  if (settings_.max_seconds && end == RenderEnd::NotYet) {
    const double left = std::max(0.0, *settings_.max_seconds - elapsed());
    progress.seconds_left = std::min(left, progress.seconds_left.value_or(left));
    progress.done = std::clamp(elapsed() / *settings_.max_seconds, progress.done, 1.0);
  }
  return progress;
}

Snapshot Render::snapshot(bool with_variance) const {
  Snapshot snapshot;
  snapshot.mean = {settings_.width, settings_.height,
                   std::vector<Rgb>(static_cast<std::size_t>(pixel_count()))};
  if (with_variance) snapshot.variance = snapshot.mean;
  FilmTile tile;
  for (int i = 0; i < film_.tile_count(); ++i) {
    copy_tile(i, tile);
    write_tile(
        tile.bounds, [&](std::size_t p) { return tile.mean(p); }, snapshot.mean);
    if (with_variance) {
      write_tile(
          tile.bounds, [&](std::size_t p) { return tile.variance(p); }, snapshot.variance);
    }
  }
  return snapshot;
}

void Render::copy_tile(int tile, FilmTile& copy) const {
  const std::lock_guard lock(lock_of(tile));
  film_.copy_tile(tile, copy);
}

std::uint32_t Render::sample_count_of(int tile) const {
  const std::lock_guard lock(lock_of(tile));
  return film_.sample_count_of(tile);
}

}  // namespace transport
