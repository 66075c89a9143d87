// Boost.Math gives the densities of statistical distributions that are sampled by rejection.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "grf/catalogue.h"
#include "grf/model.h"

namespace studies {

/// The density of a distribution on an interval: its support, cut at quantiles where that is unbounded.
struct Density {
  std::function<double(double x)> pdf;  ///< of the distribution that is not cut
  std::function<double(double x)> cdf;
  double low = 0;
  double high = 1;
  bool is_cut_low = false;
  bool is_cut_high = false;
  double mode = 0;  ///< where the density is largest in the interval, if it is finite
  /// The parameter that gives the density an infinite peak (a pole), and where it is; empty name: none.
  std::string_view pole_parameter = {};
  double pole = 0;

  bool has_pole() const { return !pole_parameter.empty(); }
  double width() const { return high - low; }
  /// Returns the probability of [from, to] under the distribution that is not cut.
  double mass(double from, double to) const { return cdf(to) - cdf(from); }
  double mass() const { return mass(low, high); }

  /// Returns the exact maximum over [from, to]; infinite at a pole. All the densities are unimodal, or
  /// largest at both ends.
  double maximum(double from, double to) const;
  double maximum() const { return maximum(low, high); }
};

/// Returns the distributions with their parameters.
std::vector<grf::ModelInfo> density_infos();

/// Makes the density of a model that was checked; nothing if no distribution has its keyword. `tail` is the
/// probability that is cut off at each unbounded end.
std::optional<Density> make_density(const grf::Model& model, double tail);

}  // namespace studies
