#include "renderer/transport/truncation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/image/image_error.h"
#include "renderer/parallel/loops.h"

namespace transport {
namespace {

using grf::Vec3d;

/// Independent estimates of each pixel, and the samples of each.
constexpr std::size_t Estimates = 4;
constexpr std::uint32_t SamplesOfEstimate = 8;
/// The pilot has a pixel for so many of the image, within bounds.
constexpr int PixelsPerPilotPixel = 64;
constexpr int FewestPilotPixels = 256;
constexpr int MostPilotPixels = 2048;
/// Light of this many bounces and more is not told apart.
constexpr int MostBounces = 32;

/// The exponent of the variance in the number of samples that an error needs: 1 / (2 a), as the error falls
/// as samples^-a. `a` is the prior of Forecast for low-discrepancy points.
constexpr double VarianceExponent = 1 / (2 * 0.74);
/// Costs are as uncertain as this.
constexpr double LeastGain = 0.95;

/// A quantity of a pixel, in each estimate.
using PixelEstimates = std::array<Vec3d, Estimates>;

PixelEstimates black() {
  PixelEstimates black;
  black.fill(Vec3d(0));
  return black;
}

/// The mean of the products of different estimates of two quantities.
Vec3d mean_product(const PixelEstimates& a, const PixelEstimates& b) {
  Vec3d sum(0);
  for (std::size_t i = 0; i < Estimates; ++i) {
    for (std::size_t j = 0; j < Estimates; ++j) {
      if (i != j) sum += a[i] * b[j];
    }
  }
  return sum / double(Estimates * (Estimates - 1));
}

/// The light of a pixel by its bounces.
class PilotPixel {
 public:
  explicit PilotPixel(int bounces)
      : bounces_(static_cast<std::size_t>(bounces)), light_(bounces_ + 1, black()) {}

  void add(std::size_t estimate, const Contribution& contribution) {
    if (!is_finite(contribution.radiance)) return;
    const std::size_t bounces = std::min(static_cast<std::size_t>(contribution.bounces), bounces_);
    light_[bounces][estimate] += Vec3d(contribution.radiance) / double(SamplesOfEstimate);
  }

  /// The light of so many bounces.
  const PixelEstimates& last(int depth) const { return light_[static_cast<std::size_t>(depth)]; }

  /// The light of more bounces.
  PixelEstimates later(int depth) const {
    PixelEstimates sum = black();
    for (auto more = static_cast<std::size_t>(depth) + 1; more <= bounces_; ++more) {
      for (std::size_t i = 0; i < Estimates; ++i) sum[i] += light_[more][i];
    }
    return sum;
  }

  /// All light, with that of the last bounce times `1 + factor` in the place of later ones.
  PixelEstimates truncated(int depth, const Vec3d& factor) const {
    PixelEstimates sum = black();
    for (std::size_t i = 0; i < Estimates; ++i) {
      for (std::size_t k = 0; k <= static_cast<std::size_t>(depth); ++k) sum[i] += light_[k][i];
      sum[i] += factor * last(depth)[i];
    }
    return sum;
  }

  PixelEstimates all() const { return truncated(static_cast<int>(bounces_), Vec3d(0)); }

  /// The weight of a squared difference in relMSE.
  Vec3d weight() const {
    Vec3d mean(0);
    for (const Vec3d& estimate : all()) mean += estimate / double(Estimates);
    return Vec3d(1) / (mean * mean + Vec3d(image::RelmseFloor));
  }

 private:
  std::size_t bounces_;
  std::vector<PixelEstimates> light_;  ///< by bounces
};

/// Chooses a pixel of the pilot: a point of a rank-1 lattice that is extensible, the additive recurrence of
/// the plastic number (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences").
Imath::V2i pixel_of_pilot(std::size_t index, const Film& film) {
  constexpr double Plastic = 1.32471795724474602596;
  const auto place = [index](double step, int size) {
    return std::min(static_cast<int>(std::fmod(0.5 + double(index) * step, 1.0) * size), size - 1);
  };
  return {place(1 / Plastic, film.width()), place(1 / (Plastic * Plastic), film.height())};
}

/// Calls `take(pixel, estimate, contributions)` for some estimates of some pixels, on several threads, and
/// returns the number of rays.
template <class Take>
std::uint64_t for_each_estimate(const CompiledScene& scene, const RenderSettings& settings,
                                std::size_t pixels, std::size_t estimates, const Take& take) {
  const Render render(scene, settings);
  std::vector<std::uint64_t> rays(pixels);
  const auto render_pixel = [&](std::size_t index) {
    const Imath::V2i pixel = pixel_of_pilot(index, render.film());
    std::vector<Contribution> contributions;
    for (std::size_t estimate = 0; estimate < estimates; ++estimate) {
      contributions.clear();
      // The film's own sequences are the first ones.
      const int scrambling = Film::Scramblings + static_cast<int>(estimate);
      for (std::uint32_t number = 0; number < SamplesOfEstimate; ++number) {
        rays[index] += render.contributions_of(pixel.x, pixel.y, scrambling, number, contributions);
      }
      take(index, estimate, contributions);
    }
  };
  parallel::run_with_threads(settings.threads, [&] { parallel::for_each_index(pixels, render_pixel); });
  std::uint64_t sum = 0;
  for (const std::uint64_t of_pixel : rays) sum += of_pixel;
  return sum;
}

std::vector<PilotPixel> pilot_of(const CompiledScene& scene, const RenderSettings& settings, int bounces) {
  const auto pixels = static_cast<std::int64_t>(settings.width) * settings.height;
  const auto count = static_cast<std::size_t>(
      std::clamp<std::int64_t>(pixels / PixelsPerPilotPixel, FewestPilotPixels, MostPilotPixels));
  std::vector<PilotPixel> pilot(count, PilotPixel(bounces));
  for_each_estimate(scene, settings, count, Estimates,
                    [&](std::size_t pixel, std::size_t estimate, const auto& contributions) {
                      for (const Contribution& one : contributions) pilot[pixel].add(estimate, one);
                    });
  return pilot;
}

/// The number of rays of some paths of at most so many bounces.
double rays_of(const CompiledScene& scene, RenderSettings settings, int depth) {
  settings.integrator.depth = depth;
  return double(for_each_estimate(scene, settings, FewestPilotPixels, 1, [](auto&&...) {}));
}

/// The light of the last bounce times this best stands for that of later ones.
Vec3d best_factor(const std::vector<PilotPixel>& pilot, int depth) {
  Vec3d products(0);
  Vec3d squares(0);
  for (const PilotPixel& pixel : pilot) {
    products += pixel.weight() * mean_product(pixel.later(depth), pixel.last(depth));
    squares += pixel.weight() * mean_product(pixel.last(depth), pixel.last(depth));
  }
  Vec3d factor(0);
  for (int channel = 0; channel < 3; ++channel) {
    if (squares[channel] > 0 && products[channel] > 0) factor[channel] = products[channel] / squares[channel];
  }
  return factor;
}

/// The bias, where the light of the last bounce, times a factor, replaces that of later ones.
ErrorEstimate bias_of(const std::vector<PilotPixel>& pilot, int depth, const Vec3d& factor) {
  double sum = 0;
  double squares = 0;
  for (const PilotPixel& pixel : pilot) {
    PixelEstimates missing = pixel.later(depth);
    for (std::size_t i = 0; i < Estimates; ++i) missing[i] -= factor * pixel.last(depth)[i];
    const double relmse = (pixel.weight() * mean_product(missing, missing)).dot(Vec3d(1.0 / 3));
    sum += relmse;
    squares += relmse * relmse;
  }
  const auto count = static_cast<double>(pilot.size());
  const double mean = sum / count;
  const double deviation = std::sqrt(std::max(0.0, squares / count - mean * mean) / (count - 1));
  const double off = student_quantile(count - 1) * deviation;
  const auto root = [](double square) { return std::sqrt(std::max(0.0, square)); };
  // A mean below 0 is by chance: 0 has the same uncertainty.
  return {root(mean), root(mean - off), root(std::max(0.0, mean) + off)};
}

/// The variance of estimates, relative as in relMSE, summed over pixels.
template <class EstimatesOf>
double variance_of(const std::vector<PilotPixel>& pilot, const EstimatesOf& estimates_of) {
  double sum = 0;
  for (const PilotPixel& pixel : pilot) {
    const PixelEstimates estimates = estimates_of(pixel);
    Vec3d squares(0);
    for (const Vec3d& estimate : estimates) squares += estimate * estimate;
    sum += (pixel.weight() * (squares / double(Estimates) - mean_product(estimates, estimates)))
               .dot(Vec3d(1.0 / 3));
  }
  return sum;
}

}  // namespace

double Truncation::cost(double target_error) const {
  if (!is_negligible(bias, target_error)) return std::numeric_limits<double>::infinity();
  const double noise = noise_target(target_error, bias) / target_error;
  return rays * std::pow(variance / (noise * noise), VarianceExponent);
}

std::vector<Truncation> truncations_of(const CompiledScene& scene, const RenderSettings& settings) {
  const int bounces = std::min(settings.integrator.depth, MostBounces);
  if (settings.integrator.integrator != Integrator::Path || bounces < 2) return {};
  RenderSettings plain = settings;
  plain.part.reset();
  plain.part_samples.clear();
  const std::vector<PilotPixel> pilot = pilot_of(scene, plain, bounces);
  const double variance = variance_of(pilot, [](const PilotPixel& pixel) { return pixel.all(); });
  const double rays = rays_of(scene, plain, settings.integrator.depth);
  std::vector<Truncation> truncations;
  for (int depth = 1; depth < bounces; ++depth) {
    const Vec3d factor = best_factor(pilot, depth);
    Truncation truncation{depth, Rgb(Vec3d(1) + factor), bias_of(pilot, depth, factor)};
    truncation.rays = rays_of(scene, plain, depth) / rays;
    if (variance > 0) {
      truncation.variance =
          variance_of(pilot, [&](const PilotPixel& pixel) { return pixel.truncated(depth, factor); }) /
          variance;
    }
    truncations.push_back(truncation);
  }
  return truncations;
}

std::optional<Truncation> truncation_for(const std::vector<Truncation>& truncations, double target_error) {
  const auto cost = [&](const Truncation& one) { return one.cost(target_error); };
  const auto best = std::ranges::min_element(truncations, {}, cost);
  if (best == truncations.end() || cost(*best) > LeastGain) return std::nullopt;
  return *best;
}

void follow(const Truncation& truncation, RenderSettings& settings) {
  settings.integrator.depth = truncation.depth;
  settings.integrator.last_bounce_factor = truncation.last_bounce_factor;
  settings.bias = truncation.bias;
}

}  // namespace transport
