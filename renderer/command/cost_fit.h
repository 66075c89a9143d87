// Curves through measured errors.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace command {

/// What was measured of one line of a sweep at one number of samples.
struct CostPoint {
  double samples = 0;
  double seconds = 0;  ///< of rendering
  double relmse = 0;
};

/// y = factor x^-exponent.
struct PowerLaw {
  double factor = 0;
  double exponent = 0;

  double at(double x) const;
  /// Where y has that value; nothing if y does not fall.
  std::optional<double> where(double y) const;
};

/// By least squares of the logarithms; nothing without two different x. All numbers must be over 0.
std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y);

/// How the error, sqrt(relMSE), falls.
struct CostFit {
  std::optional<PowerLaw> over_seconds;
  std::optional<PowerLaw> over_samples;
  std::vector<CostPoint> used;  ///< the points that counted
};

/// The reference's own error is taken off, by its relMSE, and only points with four times as much as that or
/// more count.
CostFit fit_cost(std::span<const CostPoint> points, double reference_relmse);

}  // namespace command
