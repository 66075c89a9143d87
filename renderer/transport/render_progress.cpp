// The progress of a render, and forecasts of what is left of it.
#include <algorithm>
#include <utility>

#include "renderer/transport/render.h"

namespace transport {

/// Returns the mean number of samples of the pixels that are rendered, at the end.
double Render::samples_wanted() const {
  if (part_samples_.empty()) return settings_.samples;
  double samples = 0;
  for (int tile = 0; tile < film_.tile_count(); ++tile) {
    const TileSamples& own = part_samples_[static_cast<std::size_t>(tile)];
    for (std::size_t half = 0; half < own.end.size(); ++half) {
      samples +=
          double(own.end[half] - own.first[half]) * static_cast<double>(film_.bounds_of(tile).pixel_count());
    }
  }
  return samples / std::max(1.0, pixel_count());
}

/// The forecast from the checks; before the first one, from the error estimate without neighbours.
std::optional<Forecast> Render::forecast() const {
  std::vector<ErrorCheck> known = checks();
  if (known.empty()) {
    const std::lock_guard lock(totals_lock_);
    const auto estimate = error_estimate_of(error_sums_);
    const double samples = static_cast<double>(totals_.paths) / pixel_count();
    if (!estimate || samples < 2) return std::nullopt;
    known.push_back({samples, *estimate});
  }
  const auto convergence = is_adaptive()                                     ? Convergence::Adaptive
                           : settings_.pattern == SamplePattern::Independent ? Convergence::Independent
                                                                             : Convergence::Sobol;
  return Forecast(std::move(known), convergence);
}

std::vector<TargetForecast> Render::forecasts(const std::vector<double>& target_errors) const {
  const auto forecast = this->forecast();
  const auto cost = this->cost();
  if (!forecast || !cost) return {};
  std::vector<TargetForecast> forecasts;
  for (const double target : target_errors) {
    if (!is_negligible(settings_.bias, target)) continue;
    const ForecastValue samples = forecast->samples_for(noise_target(target, settings_.bias));
    forecasts.push_back({target, samples, cost->seconds_for(samples)});
  }
  return forecasts;
}

/// The cost of the whole image; empty before the first sample, or the first check of a probe.
std::optional<RenderCost> Render::cost() const {
  const std::vector<ErrorCheck> checks = this->checks();
  if (settings_.probe) {
    if (checks.empty()) return std::nullopt;
    const auto tiles = std::count(is_rendered_.begin(), is_rendered_.end(), true);
    return cost_of_image(checks, static_cast<int>(tiles), rendered_fraction());
  }
  const RenderTotals now = totals();
  const double samples = static_cast<double>(now.paths) / pixel_count();
  if (!(samples > 0)) return std::nullopt;
  RenderCost cost;
  cost.samples = samples;
  cost.seconds = now.seconds;
  cost.seconds_per_sample = now.seconds / samples;
  return cost;
}

/// The samples needed to reach the target or the last sample, whichever comes first. Forecasts take
/// milliseconds, and progress is asked for often.
ForecastValue Render::samples_needed(double samples) const {
  const double limit = samples_wanted();
  if (!settings_.target_error) return {limit, limit, limit};
  const std::vector<ErrorCheck> known = checks();
  const double basis = known.empty() ? samples : known.back().samples;
  {
    const std::lock_guard lock(totals_lock_);
    if (needed_ && (known.empty() ? basis < 1.2 * needed_->basis : basis == needed_->basis))
      return needed_->samples;
  }
  const auto forecast = this->forecast();
  if (!forecast) return {limit, limit, limit};
  const ForecastValue needed = forecast->samples_for(noise_target(*settings_.target_error, settings_.bias));
  const std::lock_guard lock(totals_lock_);
  needed_ = {basis,
             {std::min(limit, needed.median), std::min(limit, needed.low), std::min(limit, needed.high)}};
  return needed_->samples;
}

RenderProgress Render::progress() const {
  const RenderTotals totals = this->totals();
  RenderProgress progress;
  progress.seconds = totals.seconds;
  double restored = 0;
  std::optional<ErrorEstimate> estimate;
  {
    const std::lock_guard lock(totals_lock_);
    restored = static_cast<double>(restored_paths_) / pixel_count();
    estimate = error_estimate_of(error_sums_);
  }
  if (estimate) progress.estimated_error = with_bias(*estimate, settings_.bias).error;
  const RenderEnd end = end_;
  if (end != RenderEnd::NotYet && end != RenderEnd::Stopped) {
    progress.done = 1;
    progress.seconds_left = 0;
    return progress;
  }
  const double samples = static_cast<double>(totals.paths) / pixel_count();
  const ForecastValue needed = samples_needed(samples);
  progress.done = std::min(1.0, samples / needed.median);
  if (samples > restored && needed.median < RenderSettings::Unlimited) {
    const double seconds_per_sample = elapsed() / (samples - restored);
    progress.seconds_left = std::max(0.0, needed.median - samples) * seconds_per_sample;
  }
  if (settings_.max_seconds && end == RenderEnd::NotYet) {
    const double left = std::max(0.0, *settings_.max_seconds - elapsed());
    progress.seconds_left = std::min(left, progress.seconds_left.value_or(left));
    progress.done = std::clamp(elapsed() / *settings_.max_seconds, progress.done, 1.0);
  }
  return progress;
}

}  // namespace transport
