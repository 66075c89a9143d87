// Forecasts how many samples a render needs until its estimated error reaches a target, and the time.
#pragma once

#include <optional>
#include <vector>

#include <ImathMatrix.h>

#include "renderer/transport/error_estimate.h"

namespace transport {

/// How far the 97.5 % bound of the error may exceed a target error.
constexpr double TargetErrorMargin = 1.15;

/// Returns the value that a target error limits: the estimated error, or its upper bound less the margin.
double error_against_target(const ErrorEstimate& estimate);

/// The largest part of a target error that a bias may be.
constexpr double BiasPart = 0.25;

/// Returns whether the upper bound of a bias is at most `BiasPart` of a target error.
bool is_negligible(const ErrorEstimate& bias, double target_error);

/// Returns what a target error leaves to noise, beside a negligible bias.
double noise_target(double target_error, const ErrorEstimate& bias);

/// Returns the first sample count, not less than this, at which a render with a target checks its error. They
/// grow by a fifth each time.
int error_check_from(int samples);

/// A check of a render's error.
struct ErrorCheck {
  double samples = 0;      ///< per pixel
  ErrorEstimate estimate;  ///< without a bias
  /// Standard deviation of the estimate's logarithm because only some tiles of the image were rendered.
  double sampling_deviation = 0;
  double seconds = 0;        ///< of rendering until then, without checks
  double check_seconds = 0;  ///< of all checks up to this one
};

/// How samples are distributed, on which the convergence of the error depends.
enum class Convergence { Independent, Sobol, Adaptive };

/// A forecast quantity with an interval that contains it with a probability of `Forecast::Coverage`.
struct ForecastValue {
  double median = 0;
  double low = 0;
  double high = 0;
};

/// A forecast of the error checks of a render, from those so far.
///
/// The model. Let y be the logarithm of the estimated error, and x that of the samples. Then
///
///     y(x) = m(x) + e(x),   m' = -a,
///
/// where the exponent `a` is 1/2 for independent samples, and has a prior between that and the 1 of smooth
/// integrands for Sobol points. It drifts slowly, because edges, rare light paths and smooth parts of an
/// image take turns in dominating its error. The estimate's own error e is correlated between checks, because
/// a check's samples are also those of the next one: the squared difference of two halves after n samples has
/// the correlation n / N with that after N, so e is an Ornstein-Uhlenbeck process in x with the rate 1
/// (Uhlenbeck and Ornstein 1930, "On the theory of the Brownian motion"). Its deviation follows from the
/// lower bound of the error estimate. All this is linear and Gaussian, so a Kalman filter gives the
/// distribution of (m, a, e) after the last check (Kalman 1960, "A new approach to linear filtering and
/// prediction problems").
///
/// Adaptive sampling reduces the error by an unknown factor while it takes effect.
///
/// The upper bound of an estimate must also be below the target with a margin; it is above the error by a
/// factor whose logarithm varies around its recent value.
///
/// Courses of future checks are drawn from both, and each ends at its first check below the target.
class Forecast {
 public:
  /// The probability that a stated interval contains the truth.
  static constexpr double Coverage = 0.9;

  /// Takes checks in the order of their samples, at least one.
  Forecast(std::vector<ErrorCheck> checks, Convergence convergence);

  /// Forecasts the samples per pixel at the first check that reaches a target error, without a sample limit.
  /// Exact if a check of the whole image has reached it; infinite where that is beyond any render.
  ForecastValue samples_for(double target_error) const;

 private:
  class Course;

  /// The Gaussian distribution of (m, a, e).
  struct State {
    Imath::V3d mean;
    Imath::M33d covariance;
  };

  void predict(State& state, double step) const;
  double logarithm_of(const ErrorCheck& check) const;
  State state_after_checks() const;
  double samples_of(Course course, double target) const;

  std::vector<ErrorCheck> checks_;
  Convergence convergence_;
  double deviation_ = 0;  ///< of e
  double width_ = 0;      ///< logarithm of the upper bound over the error
  State state_;           ///< after the last check
};

/// The cost of rendering an image.
struct RenderCost {
  double samples = 0;             ///< per pixel, so far
  double seconds = 0;             ///< for these
  double seconds_per_sample = 0;  ///< of each pixel, after these
  double seconds_per_check = 0;   ///< of the error
  double deviation = 0.05;        ///< standard deviation of the logarithm of the time

  /// Returns the time for this many samples. The errors of samples and cost are independent.
  ForecastValue seconds_for(const ForecastValue& count) const;
};

/// Returns the cost of the whole image from the checks of so many of its tiles, which are a fraction of it.
RenderCost cost_of_image(const std::vector<ErrorCheck>& checks, int tiles, double fraction);

/// The forecast of a render with a target error.
struct TargetForecast {
  double target_error = 0;
  ForecastValue samples;  ///< per pixel
  ForecastValue seconds;  ///< of rendering
};

/// Returns the target errors that are forecast, in descending order: 5, 2 and 1 %, and a render's own one.
std::vector<double> forecast_targets(const std::optional<double>& own);

}  // namespace transport
