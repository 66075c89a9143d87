// Power laws are fitted to measured errors.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace command {

/// A measurement of one line of a sweep at one sample count.
struct CostPoint {
  double samples = 0;
  double seconds = 0;  ///< render time, without building tables
  double relmse = 0;
};

/// y = factor x^-exponent.
struct PowerLaw {
  double factor = 0;
  double exponent = 0;

  double at(double x) const;
  /// Returns the x at which y has this value; nothing if y does not fall.
  std::optional<double> inverse(double y) const;
};

/// Fits by least squares of the logarithms; nothing without two different x. All numbers must be over 0.
std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y);

/// The fitted convergence of the error, sqrt(relMSE).
struct CostFit {
  std::optional<PowerLaw> over_seconds;
  std::optional<PowerLaw> over_samples;
  std::vector<CostPoint> used;  ///< the points that entered the fits
};

/// Rows whose relMSE is less than this many times the reference's say little about their line.
inline constexpr double WellAboveReference = 4;

/// Fits the error after subtracting the reference's relMSE from each point's. Points with less than four
/// times the reference's relMSE are left out.
CostFit fit_cost(std::span<const CostPoint> points, double reference_relmse);

}  // namespace command
