#include "renderer/transport/render.h"

#include <algorithm>

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include "renderer/transport/processor_clock.h"
#include "renderer/transport/thread_sanitizer.h"
#include "renderer/transport/threads.h"

namespace transport {
namespace {

constexpr int TileSize = 16;
/// The first passes are short so that there is soon something to look at, and a stopped image is even.
constexpr int LongestPass = 16;

static_assert(std::atomic<bool>::is_always_lock_free, "Render::stop is called from signal handlers");

}  // namespace

Render::Render(const CompiledScene& scene, const RenderSettings& settings)
    : scene_(scene),
      settings_(settings),
      kernel_(kernel_of(scene, settings.integrator)),
      camera_(seen_from(scene.origin(), settings.view), settings.width, settings.height),
      film_(settings.width, settings.height),
      start_(std::chrono::steady_clock::now()),
      start_ticks_(processor_ticks()) {}

void Render::run() {
  run_with_threads(settings_.threads, [this] {
    int pass = 1;
    for (int sample = 0; sample < settings_.samples && !stopped_;) {
      const int last = std::min(sample + pass, settings_.samples);
      run_pass(sample, last);
      sample = last;
      pass = std::min(2 * pass, LongestPass);
    }
  });
  seconds_ = elapsed();
  ticks_per_second_ = static_cast<double>(processor_ticks() - start_ticks_) / seconds_;
}

double Render::sampling_seconds() const { return static_cast<double>(sampling_ticks_) / ticks_per_second_; }

void Render::run_pass(int first_sample, int last_sample) {
  const int tiles_x = (settings_.width + TileSize - 1) / TileSize;
  const int tiles_y = (settings_.height + TileSize - 1) / TileSize;
  publish(&film_);
  tbb::parallel_for(tbb::blocked_range2d<int>(0, tiles_y, 1, 0, tiles_x, 1),
                    [&](const tbb::blocked_range2d<int>& tiles) {
                      see(&film_);
                      for (int y = tiles.rows().begin(); y != tiles.rows().end(); ++y) {
                        for (int x = tiles.cols().begin(); x != tiles.cols().end(); ++x) {
                          if (!stopped_) render_tile(x, y, first_sample, last_sample);
                        }
                      }
                      publish(&film_);
                    });
  see(&film_);
}

void Render::render_tile(int tile_x, int tile_y, int first_sample, int last_sample) {
  RayCounter counter;
  int rejected = 0;
  std::uint64_t paths = 0;
  const int end_x = std::min((tile_x + 1) * TileSize, settings_.width);
  const int end_y = std::min((tile_y + 1) * TileSize, settings_.height);
  for (int y = tile_y * TileSize; y < end_y; ++y) {
    for (int x = tile_x * TileSize; x < end_x; ++x) {
      rejected += render_pixel(x, y, first_sample, last_sample, counter);
      paths += static_cast<std::uint64_t>(last_sample - first_sample);
    }
  }
  paths_ += paths;
  rays_ += counter.rays;
  sampling_ticks_ += counter.sampling_ticks;
  rejected_ += static_cast<std::uint64_t>(rejected);
}

// Samples alternate between the scramblings, each of which takes the points of its own sequence in order.
int Render::render_pixel(int x, int y, int first_sample, int last_sample, RayCounter& counter) {
  int rejected = 0;
  const std::uint32_t pixel_seed =
      hash(hash(settings_.seed, static_cast<std::uint32_t>(x)), static_cast<std::uint32_t>(y));
  for (int sample = first_sample; sample < last_sample; ++sample) {
    const int scrambling = sample % Film::Scramblings;
    PathNumbers numbers(hash(pixel_seed, static_cast<std::uint32_t>(scrambling)),
                        static_cast<std::uint32_t>(sample / Film::Scramblings));
    const grf::Vec2f place = place_in_pixel(sample, numbers);
    const float image_x = static_cast<float>(x) + place.x;
    const float image_y = static_cast<float>(y) + place.y;
    const Rgb radiance = kernel_(scene_, settings_.integrator, camera_.ray(image_x, image_y),
                                 behind(image_x, image_y), numbers, counter);
    if (!film_.add(x, y, scrambling, radiance)) ++rejected;
  }
  return rejected;
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

double Render::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

RenderProgress Render::progress() const {
  const double total = static_cast<double>(settings_.width) * settings_.height * settings_.samples;
  RenderProgress progress;
  progress.done = std::min(1.0, static_cast<double>(paths_) / total);
  progress.seconds = elapsed();
  if (progress.done > 0) progress.seconds_left = progress.seconds * (1 - progress.done) / progress.done;
  return progress;
}

}  // namespace transport
