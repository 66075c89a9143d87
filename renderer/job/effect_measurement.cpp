#include "renderer/job/effect_measurement.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "renderer/job/camera_path.h"
#include "renderer/job/render_job.h"
#include "renderer/parallel/loops.h"
#include "renderer/transport/error_estimate.h"
#include "renderer/transport/processor_clock.h"

namespace job {
namespace {

using image::Image;
using options::RenderOptions;
using reflectance::Rgb;
using transport::Effect;
using transport::Render;
using transport::RenderSettings;

/// The rounds that a budget of time is divided into. More of them make the interval surer, fewer leave more
/// samples for each.
constexpr int RoundsOfBudget = 8;
constexpr int MostRounds = 64;
constexpr int MostSamples = 256;

double sum_of(std::span<const double> values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// The options of a small image with a fixed number of samples.
RenderOptions reduced(RenderOptions all, int largest_size) {
  const double factor =
      std::min(1.0, largest_size / static_cast<double>(std::max(all.size.width, all.size.height)));
  const auto scaled = [factor](int pixels) {
    return std::max(1, static_cast<int>(std::lround(factor * pixels)));
  };
  all.size = {scaled(all.size.width), scaled(all.size.height)};
  all.samples = 1;
  all.target_error.reset();
  all.max_seconds.reset();
  all.adaptive = false;
  all.layers.clear();
  if (const std::vector<int> frames = frames_of(all); !frames.empty()) all.frame = frames.front();
  return all;
}

RenderOptions without(RenderOptions all, Effect effect) {
  all.without.emplace_back(name_of(effect));
  return all;
}

struct Rendered {
  Image image;
  double seconds = 0;  ///< processor time per thread
};

Rendered rendered(const RenderJob& job, std::uint32_t seed, int samples) {
  RenderSettings settings = job.settings;
  settings.seed = seed;
  // The samples of other placings are a fixed grid.
  if (settings.pixel_sampling == transport::PixelSampling::Sobol) settings.samples = samples;
  Render render(job.scene, settings);
  const double start = transport::process_seconds();
  render.run();
  const double seconds = (transport::process_seconds() - start) / parallel::threads_for(settings.threads);
  return {render.snapshot().mean, seconds};
}

double light_of(const Image& image) {
  double sum = 0;
  for (const Rgb& pixel : image.pixels) sum += static_cast<double>(pixel.x) + pixel.y + pixel.z;
  return sum / (3.0 * static_cast<double>(image.pixels.size()));
}

/// Adds an image to a sum that may have no pixels yet.
void add(const Image& image, Image& sum) {
  if (sum.pixels.empty()) {
    sum = image;
    return;
  }
  for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += image.pixels[i];
}

double squared_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Imath::V3d difference = Imath::V3d(a.pixels[i]) - Imath::V3d(b.pixels[i]);
    sum += difference.dot(difference);
  }
  return sum;
}

Image mean_of(Image sum, std::size_t count) {
  for (Rgb& pixel : sum.pixels) pixel /= static_cast<float>(count);
  return sum;
}

}  // namespace

std::optional<LostShare> lost_share(std::span<const double> with, std::span<const double> without) {
  const auto n = static_cast<double>(with.size());
  const double sum = sum_of(with);
  if (!(sum > 0)) return std::nullopt;
  const double ratio = sum_of(without) / sum;
  double squares = 0;
  for (std::size_t i = 0; i < with.size(); ++i) {
    const double residual = (without[i] - ratio * with[i]) / (sum / n);
    squares += residual * residual;
  }
  const double margin = transport::student_quantile(n - 1) * std::sqrt(squares / (n - 1) / n);
  return LostShare{1 - ratio, 1 - ratio - margin, 1 - ratio + margin};
}

/// The pairs of renders with and without an effect.
class EffectMeasurement::Pairs {
 public:
  Pairs(const RenderJob& full, const RenderJob& without) : full_(full), without_(without) {}

  /// Renders one sample per pixel, and returns how long a sample of the full image takes.
  double try_out() {
    rendered(without_, full_.settings.seed, 1);
    return rendered(full_, full_.settings.seed, 1).seconds;
  }

  void add_round(int samples) {
    const auto round = static_cast<std::uint32_t>(count());
    const std::uint32_t seed = full_.settings.seed + round;
    // What slows down the machine meanwhile affects both alike.
    const bool is_full_first = round % 2 == 0;
    Rendered first = rendered(is_full_first ? full_ : without_, seed, samples);
    Rendered second = rendered(is_full_first ? without_ : full_, seed, samples);
    if (!is_full_first) std::swap(first, second);
    light_with_.push_back(light_of(first.image));
    light_without_.push_back(light_of(second.image));
    time_with_.push_back(first.seconds);
    time_without_.push_back(second.seconds);
    squares_ += squared_difference(first.image, second.image);
    add(first.image, sum_with_);
    add(second.image, sum_without_);
  }

  std::size_t count() const { return light_with_.size(); }
  double seconds() const { return sum_of(time_with_) + sum_of(time_without_); }

  MeasuredEffect result(Effect effect) const {
    MeasuredEffect measured;
    measured.effect = effect;
    measured.light = lost_share(light_with_, light_without_);
    measured.time = lost_share(time_with_, time_without_);
    measured.full = mean_of(sum_with_, count());
    measured.without = mean_of(sum_without_, count());
    if (measured.light) measured.difference = difference();
    return measured;
  }

 private:
  /// The mean over pairs of different rounds of the product of their differences has no bias by noise.
  double difference() const {
    const auto n = static_cast<double>(count());
    const double products = (squared_difference(sum_with_, sum_without_) - squares_) / (n * (n - 1));
    const double values = 3.0 * static_cast<double>(sum_with_.pixels.size());
    return std::sqrt(std::max(0.0, products / values)) / (sum_of(light_with_) / n);
  }

  const RenderJob& full_;
  const RenderJob& without_;
  std::vector<double> light_with_, light_without_, time_with_, time_without_;
  double squares_ = 0;  ///< of the rounds' differences
  Image sum_with_, sum_without_;
};

EffectMeasurement::EffectMeasurement(const RenderOptions& render_options, const plan::Plan& plan,
                                     const MeasurementSettings& settings, Listener listener)
    : options_(reduced(render_options, settings.largest_size)),
      settings_(settings),
      listener_(std::move(listener)) {
  for (const plan::PlannedEffect& planned : plan.effects) {
    if (planned.is_needed && planned.effect != Effect::Instances) effects_.push_back(planned.effect);
  }
}

void EffectMeasurement::run() {
  const auto full = render_job(options_, diagnostics_);
  if (!full) return;
  const double budget = settings_.seconds / static_cast<double>(std::max<std::size_t>(1, effects_.size()));
  for (const Effect effect : effects_) {
    grf::Diagnostics repeated;  // the full render's job has reported these warnings
    const auto lacking = render_job(without(options_, effect), repeated);
    if (!lacking) {
      diagnostics_ = std::move(repeated);
      return;
    }
    Pairs pairs(*full, *lacking);
    const double affordable = budget / (2 * RoundsOfBudget * std::max(1e-6, pairs.try_out()));
    const auto samples = static_cast<int>(std::bit_floor(static_cast<unsigned>(
        std::clamp<double>(affordable, 1, MostSamples))));  // a Sobol sequence's powers of two
    const auto is_wanted = [&] {
      const auto count = static_cast<int>(pairs.count());
      return count < settings_.fewest_rounds || (pairs.seconds() < budget && count < MostRounds);
    };
    while (is_wanted() && !is_stopped_) pairs.add_round(samples);
    if (static_cast<int>(pairs.count()) >= settings_.fewest_rounds) listener_(pairs.result(effect));
    if (is_stopped_) return;
  }
}

}  // namespace job
