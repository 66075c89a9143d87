// Effects of a scene are measured by rendering with and without each of them: what they cost and contribute.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/image/image.h"
#include "renderer/options/render_options.h"
#include "renderer/plan/plan.h"

namespace job {

/// A fraction of a whole that is lost without a part, with its 95 % confidence interval. It is negative if
/// the whole is more without the part.
struct LostShare {
  double value = 0;
  double low = 0;
  double high = 0;
};

/// Returns 1 - sum(without) / sum(with), from pairs of independent measurements: two or more. The interval is
/// that of a ratio estimator, with the residuals of the pairs and Student's t distribution (Cochran 1977,
/// "Sampling Techniques", section 6.3). Returns nothing if the sum with the part is not over 0.
std::optional<LostShare> lost_share(std::span<const double> with, std::span<const double> without);

struct MeasuredEffect {
  transport::Effect effect = {};
  /// The share of the image's light, its mean over pixels and channels, that is lost if the effect is
  /// switched off and what stands in for it is rendered. Nothing if the image is black.
  std::optional<LostShare> light;
  std::optional<LostShare> time;  ///< of rendering with as many samples, in processor time
  /// The root of the mean squared difference of pixels and channels, as a fraction of the image's light. The
  /// noise of independent renders does not bias its square. Nothing if the image is black.
  std::optional<double> difference;
  image::Image full;     ///< the mean of the renders with all effects
  image::Image without;  ///< the same without this one, by the same random numbers
};

struct MeasurementSettings {
  double seconds = 20;     ///< processor time per thread for all effects, without reading and compiling
  int largest_size = 160;  ///< of the image's width and height, pixels: larger images are reduced
  int fewest_rounds = 4;   ///< per effect, even if that takes longer
};

/// Measures the effects that a plan needs, one after the other. Each round renders a reduced image with and
/// without the effect, by the same random numbers, and each round has other ones. Instances are not measured:
/// the image is the same, and without them a scene may not fit into memory.
class EffectMeasurement {
 public:
  using Listener = std::function<void(const MeasuredEffect& measured)>;

  /// The listener is called in the thread of `run`.
  EffectMeasurement(const options::RenderOptions& render_options, const plan::Plan& plan,
                    const MeasurementSettings& settings, Listener listener);

  void run();
  /// Makes `run` return after the current pair of renders; an effect with too few rounds is not reported.
  void stop() { is_stopped_ = true; }

  /// The number of effects to measure.
  std::size_t effect_count() const { return effects_.size(); }
  options::ImageSize size() const { return options_.size; }
  /// Errors of reading and compiling the scene; to be called once `run` has returned.
  const grf::Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  class Pairs;

  options::RenderOptions options_;
  std::vector<transport::Effect> effects_;
  MeasurementSettings settings_;
  Listener listener_;
  std::atomic<bool> is_stopped_ = false;
  grf::Diagnostics diagnostics_;
};

}  // namespace job
