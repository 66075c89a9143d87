#include "renderer/transport/forecast.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <utility>

#include "renderer/transport/adaptive_sampling.h"

namespace transport {
namespace {

/// What is known about convergence before the first check.
struct Prior {
  double exponent = 0;
  double deviation = 0;  ///< of the exponent
  double drift = 0;      ///< variance that the exponent gains while samples grow by a factor of e
  /// Logarithm of the factor by which adaptive sampling reduces the error once it has taken effect, and its
  /// deviation.
  double gain = 0;
  double gain_deviation = 0;
};

// Measured over the scenes of forecast_statistics_test, as are the constants below.
Prior prior_of(Convergence convergence) {
  switch (convergence) {
    case Convergence::Independent:
      return {0.5, 0.03, 0.0005, 0, 0};
    case Convergence::Adaptive:
      return {0.7, 0.12, 0.004, 0.2, 0.25};
    case Convergence::Sobol:
      break;
  }
  return {0.74, 0.12, 0.002, 0, 0};
}

/// How far adaptive sampling has taken effect, from 0 to 1: samples before its decision are uniform, and the
/// tiles with too many of these have no more until the others have caught up.
double adapted_part(double samples) {
  constexpr double First = AdaptiveSampling::PilotSamples;
  constexpr double Last = 4 * First;
  return std::clamp(std::log(samples / First) / std::log(Last / First), 0.0, 1.0);
}

/// The least exponent: a mean over samples never gets worse for long.
constexpr double LeastExponent = 0.1;

/// The deviation of an estimate, over that which its lower bound states for the quotient of estimate and
/// truth: fewer pixels than those that are known make up its error.
constexpr double EstimatePart = 1.0;
constexpr double LeastDeviation = 0.01;

/// The deviation of the logarithm of `width`: from check to check, and its drift while samples grow by a
/// factor of e.
constexpr double WidthNoise = 0.5;
constexpr double WidthDrift = 0.15;

/// The checks whose median is taken for what varies much.
constexpr std::size_t RecentChecks = 5;

/// The number of courses of which quantiles are taken.
constexpr int Courses = 300;
constexpr double MostSamples = 1e12;

/// The 97.5 % and 95 % quantiles of the standard normal distribution.
constexpr double BoundQuantile = 1.96;
constexpr double CoverageQuantile = 1.645;

/// The deviation of the time per sample of tiles, relative to their mean.
constexpr double TileCostDeviation = 0.5;
/// The deviation of the logarithm of the time per sample between a short probe and a long render: of caches
/// and clock rates.
constexpr double ProbeCostDeviation = 0.08;

/// The samples at the next check.
double next_check(double samples) {
  if (samples < 1e9) return error_check_from(static_cast<int>(samples) + 1);
  return 1.2 * samples;
}

/// The median over the recent checks.
template <class Function>
double recent_median(const std::vector<ErrorCheck>& checks, const Function& function) {
  std::vector<double> values;
  const std::size_t count = std::min(checks.size(), RecentChecks);
  for (std::size_t i = checks.size() - count; i < checks.size(); ++i) values.push_back(function(checks[i]));
  std::sort(values.begin(), values.end());
  return values[count / 2];
}

/// The logarithm of a quotient of bounds; that of e where they say nothing.
double logarithm_of_quotient(double above, double below) { return below > 0 ? std::log(above / below) : 1; }

}  // namespace

double error_against_target(const ErrorEstimate& estimate) {
  return std::max(estimate.error, estimate.high / TargetErrorMargin);
}

bool is_negligible(const ErrorEstimate& bias, double target_error) {
  return bias.high <= BiasPart * target_error;
}

double noise_target(double target_error, const ErrorEstimate& bias) {
  const double part = error_against_target(bias) / target_error;
  return target_error * std::sqrt(1 - part * part);
}

int error_check_from(int samples) {
  std::int64_t check = 16;
  while (check < samples) check += std::max<std::int64_t>(4, (check / 5 + 1) / 2 * 2);
  return static_cast<int>(std::min<std::int64_t>(check, std::numeric_limits<int>::max()));
}

/// One possible course of the checks after the last one.
class Forecast::Course {
 public:
  Course(const Forecast& forecast, std::mt19937& random)
      : forecast_(forecast), prior_(prior_of(forecast.convergence_)), random_(random) {
    const ErrorCheck& last = forecast.checks_.back();
    offset_ = last.sampling_deviation * normal();
    const State& state = forecast.state_;
    const double mm = state.covariance[0][0];
    const double slope = mm > 0 ? state.covariance[0][1] / mm : 0;
    m_ = state.mean[0] + std::sqrt(std::max(0.0, mm)) * normal();
    a_ = state.mean[1] + slope * (m_ - state.mean[0]) +
         std::sqrt(std::max(0.0, state.covariance[1][1] - slope * state.covariance[0][1])) * normal();
    gain_ = prior_.gain + prior_.gain_deviation * normal();
    e_ = forecast.logarithm_of(last) - m_;
    // Of the gain so far, the mean was taken off.
    m_ += (gain_ - prior_.gain) * adapted_part(last.samples);
    log_width_ = std::log(std::max(1e-3, forecast.width_));
    samples_ = last.samples;
  }

  /// The logarithm of the whole image's error over that of the tiles that were rendered.
  double offset() const { return offset_; }

  /// Proceeds to the next check and returns its samples.
  double proceed() {
    const double next = next_check(samples_);
    const double step = std::log(next / samples_);
    samples_ = next;
    const double before = a_;
    a_ = std::max(LeastExponent, a_ + std::sqrt(prior_.drift * step) * normal());
    m_ -= step * (before + a_) / 2;
    const double kept = std::exp(-step);
    e_ = e_ * kept + forecast_.deviation_ * std::sqrt(1 - kept * kept) * normal();
    log_width_ += WidthDrift * std::sqrt(step) * normal();
    return samples_;
  }

  /// The logarithm of `error_against_target` at this check.
  double error() {
    const double width = std::exp(log_width_ + WidthNoise * normal());
    return m_ - gain_ * adapted_part(samples_) + e_ + offset_ +
           std::max(0.0, width - std::log(TargetErrorMargin));
  }

 private:
  double normal() { return normal_(random_); }

  const Forecast& forecast_;
  const Prior prior_;
  double gain_ = 0;
  std::mt19937& random_;
  std::normal_distribution<double> normal_;
  double offset_ = 0;
  double m_ = 0;
  double a_ = 0;
  double e_ = 0;
  double log_width_ = 0;
  double samples_ = 0;
};

Forecast::Forecast(std::vector<ErrorCheck> checks, Convergence convergence)
    : checks_(std::move(checks)), convergence_(convergence) {
  const double below = recent_median(checks_, [](const ErrorCheck& check) {
    return logarithm_of_quotient(check.estimate.error, check.estimate.low);
  });
  // The bound is that of the quotient of two values with the same deviation.
  deviation_ = std::max(LeastDeviation, EstimatePart * below / (BoundQuantile * std::sqrt(2.0)));
  width_ = recent_median(checks_, [](const ErrorCheck& check) {
    return logarithm_of_quotient(check.estimate.high, check.estimate.error);
  });
  state_ = state_after_checks();
}

/// The logarithm of a check's error, without the expected gain of adaptive sampling.
double Forecast::logarithm_of(const ErrorCheck& check) const {
  return std::log(check.estimate.error) + prior_of(convergence_).gain * adapted_part(check.samples);
}

/// Takes a state to that at samples larger by the factor exp(step).
void Forecast::predict(State& state, double step) const {
  const double kept = std::exp(-step);
  const double drift = prior_of(convergence_).drift;
  const Imath::M33d transition(1, -step, 0, 0, 1, 0, 0, 0, kept);
  const Imath::M33d noise(drift * step * step * step / 3, -drift * step * step / 2, 0,  //
                          -drift * step * step / 2, drift * step, 0,                    //
                          0, 0, deviation_ * deviation_ * (1 - kept * kept));
  state.mean = {state.mean[0] - step * state.mean[1], state.mean[1], kept * state.mean[2]};
  state.covariance = transition * state.covariance * transition.transposed() + noise;
}

Forecast::State Forecast::state_after_checks() const {
  constexpr double Unknown = 100;
  constexpr double Rounding = 1e-9;  // variance of what is observed
  const Prior prior = prior_of(convergence_);
  State state = {{0, prior.exponent, 0},
                 {Unknown, 0, 0, 0, prior.deviation * prior.deviation, 0, 0, 0, deviation_ * deviation_}};
  double before = checks_.front().samples;
  for (const ErrorCheck& check : checks_) {
    if (!(check.estimate.error > 0)) continue;
    predict(state, std::log(check.samples / before));
    before = check.samples;
    // What is observed is m + e.
    const Imath::M33d& c = state.covariance;
    const Imath::V3d with_observed(c[0][0] + c[0][2], c[1][0] + c[1][2], c[2][0] + c[2][2]);
    const double variance = with_observed[0] + with_observed[2] + Rounding;
    const double surprise = logarithm_of(check) - state.mean[0] - state.mean[2];
    state.mean += with_observed * (surprise / variance);
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) state.covariance[i][k] -= with_observed[i] * with_observed[k] / variance;
    }
  }
  return state;
}

double Forecast::samples_of(Course course, double target) const {
  for (const ErrorCheck& check : checks_) {
    if (std::log(error_against_target(check.estimate)) + course.offset() <= target) return check.samples;
  }
  for (double samples = 0; samples < MostSamples;) {
    samples = course.proceed();
    if (course.error() <= target) return samples;
  }
  return std::numeric_limits<double>::infinity();
}

ForecastValue Forecast::samples_for(double target_error) const {
  std::mt19937 random;  // with the same seed each time, so that a forecast changes only with its checks
  std::vector<double> samples;
  for (int i = 0; i < Courses; ++i) {
    samples.push_back(samples_of(Course(*this, random), std::log(target_error)));
  }
  std::sort(samples.begin(), samples.end());
  const auto quantile = [&](double part) {
    return samples[static_cast<std::size_t>(std::lround(part * (Courses - 1)))];
  };
  return {quantile(0.5), quantile((1 - Coverage) / 2), quantile((1 + Coverage) / 2)};
}

ForecastValue RenderCost::seconds_for(const ForecastValue& count) const {
  const auto seconds_at = [&](double wanted) {
    if (!std::isfinite(wanted)) return wanted;
    const double checks = 1 + std::log(std::max(1.0, wanted / 16)) / std::log(1.2);
    const double rendering = wanted > samples ? seconds + seconds_per_sample * (wanted - samples)
                                              : seconds * wanted / std::max(1.0, samples);
    return rendering + seconds_per_check * checks;
  };
  const double median = seconds_at(count.median);
  const auto bound = [&](double wanted, double sign) {
    const double there = seconds_at(wanted);
    if (!std::isfinite(there) || !std::isfinite(median) || !(median > 0)) return there;
    return median * std::exp(sign * std::hypot(std::log(there / median), CoverageQuantile * deviation));
  };
  return {median, bound(count.low, -1), bound(count.high, 1)};
}

std::vector<double> forecast_targets(const std::optional<double>& own) {
  std::vector<double> targets = {0.05, 0.02, 0.01};
  const auto is_own = [&](double target) { return std::abs(target - *own) < 1e-6 * target; };
  // Options are floats, which are shown as the decimal numbers that they were.
  if (own && std::none_of(targets.begin(), targets.end(), is_own)) {
    targets.push_back(std::round(*own * 1e7) / 1e7);
  }
  std::sort(targets.begin(), targets.end(), std::greater<>());
  return targets;
}

RenderCost cost_of_image(const std::vector<ErrorCheck>& checks, int tiles, double fraction) {
  const ErrorCheck& last = checks.back();
  RenderCost cost;
  cost.samples = last.samples;
  cost.seconds = last.seconds / fraction;
  cost.seconds_per_sample = cost.seconds / last.samples;
  // If samples are distributed adaptively, those before that decision cost differently.
  const auto half = std::find_if(checks.begin(), checks.end(),
                                 [&](const ErrorCheck& check) { return check.samples >= last.samples / 3; });
  if (half->samples < 0.6 * last.samples) {
    cost.seconds_per_sample = (last.seconds - half->seconds) / fraction / (last.samples - half->samples);
  }
  cost.seconds_per_check = last.check_seconds / static_cast<double>(checks.size()) / fraction;
  cost.deviation = std::hypot(ProbeCostDeviation, TileCostDeviation * std::sqrt((1 - fraction) / tiles));
  return cost;
}

}  // namespace transport
