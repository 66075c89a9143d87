#include "renderer/transport/render.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/parallel/loops.h"
#include "renderer/transport/processor_clock.h"

namespace transport {
namespace {

static_assert(std::atomic<bool>::is_always_lock_free, "Render::stop is called from signal handlers");

constexpr int Pilot = AdaptiveSampling::PilotSamples;

/// Chooses tiles spread evenly over the image: those hit by the points of a rank-1 lattice that is
/// extensible, the additive recurrence of the plastic number (Roberts 2018, "The unreasonable effectiveness
/// of quasirandom sequences").
std::vector<bool> tiles_of_probe(const Film& film, int count) {
  constexpr double Plastic = 1.32471795724474602596;
  std::vector<bool> chosen(static_cast<std::size_t>(film.tile_count()), count >= film.tile_count());
  if (count >= film.tile_count()) return chosen;
  const auto place = [](int i, double step, int places) {
    return static_cast<int>(std::fmod(0.5 + i * step, 1.0) * places);
  };
  for (int i = 0, left = count; left > 0; ++i) {
    const int x = place(i, 1 / Plastic, film.tiles_across());
    const int y = place(i, 1 / (Plastic * Plastic), film.tiles_down());
    const auto tile = static_cast<std::size_t>(y) * static_cast<std::size_t>(film.tiles_across()) +
                      static_cast<std::size_t>(x);
    if (!chosen[tile]) --left;
    chosen[tile] = true;
  }
  return chosen;
}

}  // namespace

int stage_end(const RenderSettings& settings, int samples) {
  int end = settings.samples;
  if (settings.is_adaptive() && samples <= Pilot) {
    end = samples <= Pilot / 2 ? Pilot / 2 : Pilot;
  } else if (settings.checks_error() ||
             (settings.is_adaptive() && settings.samples == RenderSettings::Unlimited)) {
    end = error_check_from(samples);
  }
  return std::min(end, settings.samples);
}

Render::Render(const CompiledScene& scene, const RenderSettings& settings)
    : scene_(scene),
      settings_(settings),
      crop_(settings.crop.value_or(CropWindow{0, 0, settings.width, settings.height})),
      kernel_(kernel_of(scene, settings.integrator)),
      camera_(camera_of(scene, settings.view, settings.width, settings.height)),
      film_(crop_.width, crop_.height),
      is_rendered_(tiles_of_probe(film_, settings.probe ? settings.probe->tiles : film_.tile_count())),
      start_(std::chrono::steady_clock::now()),
      start_ticks_(processor_ticks()),
      start_process_seconds_(process_seconds()) {
  if (settings_.part) take_part();
  for (int tile = 0; tile < film_.tile_count(); ++tile) {
    if (renders(tile)) pixel_count_ += static_cast<double>(film_.bounds_of(tile).pixel_count());
  }
}

/// Chooses the samples of the part that the settings ask for.
void Render::take_part() {
  const ImagePart& part = *settings_.part;
  if (is_adaptive() && settings_.part_samples.empty()) {
    settings_.samples = std::min(settings_.samples, Pilot);
    for (int tile = 0; tile < film_.tile_count(); ++tile) {
      is_rendered_[static_cast<std::size_t>(tile)] = has_pilot_of(part, tile);
    }
    return;
  }
  part_samples_ = settings_.part_samples.empty() ? samples_of(part, counts_at(settings_.samples))
                                                 : settings_.part_samples;
  for (std::size_t tile = 0; tile < part_samples_.size(); ++tile) {
    is_rendered_[tile] = part_samples_[tile].end != part_samples_[tile].first;
  }
}

/// Returns the number of the first sample of a half of a tile: 0 unless a part is rendered.
std::uint32_t Render::first_sample(int tile, std::size_t half) const {
  return part_samples_.empty() ? 0 : part_samples_[static_cast<std::size_t>(tile)].first[half];
}

void Render::restore(const RenderTotals& totals) {
  totals_ = totals;
  restored_paths_ = totals.paths;
}

void Render::restore_tile(int tile, const FilmTile& sums) {
  // If a pilot is incomplete, the state of its first half is lost.
  const auto samples = static_cast<int>(sums.sample_count());
  const bool is_half_done = samples > Pilot / 2 && samples < Pilot && settings_.samples >= Pilot;
  if (is_adaptive() && is_half_done) return;
  film_.put_back(tile, sums);
  error_sums_ += film_.error_sums_of(tile);
}

void Render::run() {
  RenderEnd end = RenderEnd::NotYet;
  parallel::run_with_threads(settings_.threads, [&] { end = run_stages(); });
  const RenderTotals all = totals();
  const std::lock_guard lock(totals_lock_);
  totals_ = all;
  end_ = end;
}

RenderEnd Render::run_stages() {
  for (int samples = 0;; ++samples) {
    if (is_adaptive() && !adaptive_sampling_ && has_pilot()) adaptive_sampling_.emplace(film_);
    samples = stage_from(samples);
    if (samples < settings_.samples && exceeds(samples)) continue;  // an earlier run got beyond this
    if (!run_stage(samples)) return stopped_ ? RenderEnd::Stopped : RenderEnd::Time;
    if (settings_.checks_error()) {
      const RenderEnd end = check_error(samples);
      if (end != RenderEnd::NotYet) return end;
    }
    if (samples == settings_.samples) return RenderEnd::Samples;
  }
}

/// Returns where the next stage ends, at no fewer than this many samples.
int Render::stage_from(int samples) const {
  return part_samples_.empty() ? stage_end(settings_, samples) : settings_.samples;
}

bool Render::has_pilot() const {
  for (int tile = 0; tile < film_.tile_count(); ++tile) {
    if (renders(tile) && film_.sample_count_of(tile) < static_cast<std::uint32_t>(Pilot)) return false;
  }
  return true;
}

/// Sample counts of each tile for this mean number of samples per pixel.
std::vector<FilmTile::Counts> Render::counts_at(int samples) const {
  std::vector<FilmTile::Counts> counts(static_cast<std::size_t>(film_.tile_count()));
  for (std::size_t tile = 0; tile < part_samples_.size(); ++tile) {
    const TileSamples& own = part_samples_[tile];
    counts[tile] = {own.end[0] - own.first[0], own.end[1] - own.first[1]};
  }
  if (!part_samples_.empty()) return counts;
  if (adaptive_sampling_ && samples > Pilot) return adaptive_sampling_->counts(samples);
  for (int tile = 0; tile < film_.tile_count(); ++tile) {
    if (renders(tile)) counts[static_cast<std::size_t>(tile)] = uniform_counts(samples);
  }
  return counts;
}

/// Whether some tile already has more samples than it would have at this many per pixel.
bool Render::exceeds(int samples) const {
  const std::vector<FilmTile::Counts> wanted = counts_at(samples);
  for (int tile = 0; tile < film_.tile_count(); ++tile) {
    const FilmTile::Counts& present = film_.counts_of(tile);
    const FilmTile::Counts& most = wanted[static_cast<std::size_t>(tile)];
    if (present[0] > most[0] || present[1] > most[1]) return true;
  }
  return false;
}

/// Renders until pixels have this mean number of samples; false if that ended early.
bool Render::run_stage(int samples) {
  const auto item_size =
      is_adaptive() && samples == Pilot ? TileQueue::ItemSize::Whole : TileQueue::ItemSize::Short;
  TileQueue queue(film_, counts_at(samples), parallel::thread_count(), item_size);
  parallel::on_each_thread([&] { work(queue); });
  return queue.is_finished();
}

std::optional<ErrorEstimate> Render::error_estimate() const {
  std::optional<ErrorEstimate> estimate;
  parallel::run_with_threads(settings_.threads, [&] { estimate = film_.error_estimate(); });
  if (estimate) estimate = with_bias(*estimate, settings_.bias);
  return estimate;
}

/// Checks the error after a stage, and returns whether that ends the render.
RenderEnd Render::check_error(int samples) {
  const double now = render_clock();
  const auto sampled = film_.sampled_error();
  if (!sampled) return RenderEnd::NotYet;
  const double end = render_clock();
  const std::lock_guard lock(totals_lock_);
  const double before = checks_.empty() ? 0 : checks_.back().check_seconds;
  checks_.push_back({static_cast<double>(samples), sampled->estimate, sampled->deviation, now - before,
                     before + end - now});
  if (settings_.probe && end >= settings_.probe->seconds) return RenderEnd::Time;
  const bool is_reached =
      settings_.target_error &&
      error_against_target(with_bias(sampled->estimate, settings_.bias)) <= *settings_.target_error;
  return is_reached ? RenderEnd::TargetError : RenderEnd::NotYet;
}

std::vector<ErrorCheck> Render::checks() const {
  const std::lock_guard lock(totals_lock_);
  return checks_;
}

double Render::rendered_fraction() const {
  return pixel_count() / (static_cast<double>(film_.width()) * film_.height());
}

void Render::work(TileQueue& queue) try {
  FilmTile tile;
  while (!ends_early()) {
    const auto piece = queue.take();
    if (!piece || !render_tile(*piece, tile)) return;
    queue.done(*piece);
  }
} catch (...) {
  stop();  // the other threads need not continue
  throw;
}

/// Adds samples to a tile that no other worker writes. False if that ended early: the tile then stays as it
/// was, so that all of its pixels have equally many samples.
bool Render::render_tile(const TileWork& work, FilmTile& tile) {
  film_.copy_tile(work.tile, tile);
  const bool ends_pilot = is_adaptive() && tile.sample_count() == Pilot / 2 &&
                          work.last[0] + work.last[1] == static_cast<std::uint32_t>(Pilot);
  std::optional<FilmTile> before;
  if (ends_pilot) before = tile;
  RenderTotals done;
  RayCounter counter;
  for (int y = 0; y < tile.bounds.height; ++y) {
    if (ends_early()) return false;
    for (int x = 0; x < tile.bounds.width; ++x) render_pixel(work, x, y, tile, done, counter);
  }
  tile.counts = work.last;
  for (int half = 0; ends_pilot && half < Film::Scramblings; ++half) {
    tile.spreads[static_cast<std::size_t>(half)] = tile.spread_since(*before, half);
  }
  const std::uint32_t samples = work.last[0] + work.last[1] - work.first[0] - work.first[1];
  done.paths = tile.bounds.pixel_count() * samples;
  done.rays = counter.rays;
  keep_tile(work, tile, done, counter.sampling_ticks);
  return true;
}

/// Adds samples to a pixel, given its position within the tile.
void Render::render_pixel(const TileWork& work, int x, int y, FilmTile& tile, RenderTotals& done,
                          RayCounter& counter) const {
  const int image_x = tile.bounds.x + x;
  const int image_y = tile.bounds.y + y;
  for (std::size_t half = 0; half < work.first.size(); ++half) {
    const int scrambling = static_cast<int>(half);
    const std::uint32_t before = first_sample(work.tile, half);
    for (std::uint32_t number = before + work.first[half]; number < before + work.last[half]; ++number) {
      const Rgb radiance = sample(kernel_, image_x, image_y, scrambling, number, counter);
      if (tile.add(x, y, scrambling, radiance)) continue;
      assert(is_finite(radiance) && "a sample is not finite");
      ++done.rejected;
      const auto index = static_cast<std::uint64_t>(image_y) * film_.width() + image_x;
      done.first_rejected = std::min(done.first_rejected, index);
    }
  }
}

void Render::keep_tile(const TileWork& work, const FilmTile& tile, const RenderTotals& done,
                       std::uint64_t sampling_ticks) {
  const ErrorSums before = film_.error_sums_of(work.tile);
  const ErrorSums now = tile.error_sums();
  {
    const std::lock_guard lock(lock_of(work.tile));
    film_.put_back(work.tile, tile, now);
  }
  const std::lock_guard lock(totals_lock_);
  totals_.paths += done.paths;
  totals_.rays += done.rays;
  totals_.rejected += done.rejected;
  totals_.first_rejected = std::min(totals_.first_rejected, done.first_rejected);
  sampling_ticks_ += sampling_ticks;
  error_sums_ += now - before;
}

// Each scrambling uses the samples of its own sequence in order. The position is that in the crop window.
Rgb Render::sample(Kernel kernel, int crop_x, int crop_y, int scrambling, std::uint32_t number,
                   RayCounter& counter) const {
  const int x = crop_.x + crop_x;
  const int y = crop_.y + crop_y;
  const std::uint32_t pixel_seed =
      hash(hash(settings_.seed, static_cast<std::uint32_t>(x)), static_cast<std::uint32_t>(y));
  PathSampler sampler(hash(pixel_seed, static_cast<std::uint32_t>(scrambling)), number, settings_.pattern);
  const Uniform4 place = place_in_pixel(static_cast<int>(number) * Film::Scramblings + scrambling, sampler);
  const float image_x = static_cast<float>(x) + place.x;
  const float image_y = static_cast<float>(y) + place.y;
  const Ray ray = camera_.ray(image_x, image_y, {place.z, place.w});
  return kernel(scene_, settings_.integrator, ray, backplate_at(image_x, image_y), sampler, counter);
}

std::uint64_t Render::contributions_of(int x, int y, int scrambling, std::uint32_t number,
                                       std::vector<Contribution>& contributions) const {
  RayCounter counter;
  counter.contributions = &contributions;
  sample(observing_kernel_of(scene_, settings_.integrator), x, y, scrambling, number, counter);
  return counter.rays;
}

std::optional<NotFinite> Render::cause_of_rejection() const {
  const RenderTotals all = totals();
  if (all.rejected == 0) return std::nullopt;
  const auto width = static_cast<std::uint64_t>(film_.width());
  const int x = static_cast<int>(all.first_rejected % width);
  const int y = static_cast<int>(all.first_rejected / width);
  const Kernel kernel = observing_kernel_of(scene_, settings_.integrator);
  const int tile = film_.tile_of(x, y);
  const FilmTile::Counts& counts = film_.counts_of(tile);
  for (int scrambling = 0; scrambling < Film::Scramblings; ++scrambling) {
    const auto half = static_cast<std::size_t>(scrambling);
    const std::uint32_t first = first_sample(tile, half);
    for (std::uint32_t number = first; number < first + counts[half]; ++number) {
      NotFinite found;
      RayCounter counter;
      counter.not_finite = &found;
      if (!ExactRgbSum::can_add(sample(kernel, x, y, scrambling, number, counter))) return found;
    }
  }
  return NotFinite();
}

Uniform4 Render::place_in_pixel(int sample, PathSampler& sampler) const {
  // The first four dimensions are the position in the pixel and the one on the lens, so that they are
  // stratified together.
  Uniform4 place;
  if (settings_.pixel_sampling == PixelSampling::Sobol || camera_.has_lens()) place = sampler.next();
  switch (settings_.pixel_sampling) {
    case PixelSampling::Centre:
      return {0.5F, 0.5F, place.z, place.w};
    case PixelSampling::Regular: {
      const int columns = settings_.grid_columns;
      const int rows = (settings_.samples + columns - 1) / columns;
      const auto middle = [](int cell, int count) {
        return (static_cast<float>(cell) + 0.5F) / static_cast<float>(count);
      };
      return {middle(sample % columns, columns), middle(sample / columns, rows), place.z, place.w};
    }
    case PixelSampling::Sobol:
      break;
  }
  return place;
}

std::optional<Rgb> Render::backplate_at(float x, float y) const {
  if (!settings_.backplate) return std::nullopt;
  const auto index_of = [](float place, int size, int count) {
    return std::min(static_cast<int>(place / static_cast<float>(size) * static_cast<float>(count)),
                    count - 1);
  };
  const image::Image& plate = *settings_.backplate;
  return plate.at(index_of(x, settings_.width, plate.width), index_of(y, settings_.height, plate.height));
}

bool Render::ends_early() {
  if (settings_.max_seconds && elapsed() >= *settings_.max_seconds) out_of_time_ = true;
  return stopped_ || out_of_time_;
}

double Render::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

/// The time in which checks are measured, in seconds: for a probe, that of the processor per thread.
double Render::render_clock() const {
  if (!settings_.probe) return elapsed();
  return (process_seconds() - start_process_seconds_) / parallel::thread_count();
}

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

Snapshot Render::snapshot(bool with_variance) const {
  Snapshot snapshot;
  snapshot.mean = {
      film_.width(), film_.height(),
      std::vector<Rgb>(static_cast<std::size_t>(film_.width()) * static_cast<std::size_t>(film_.height()))};
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
