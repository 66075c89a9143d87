// Errors of estimates of reflected radiance.
#pragma once

#include <array>
#include <string_view>

#include "samples/studies/sampling/lighting.h"
#include "samples/studies/sampling/technique.h"

namespace study {

constexpr std::array<int, 5> SampleCounts = {1, 4, 16, 64, 256};

enum Points : std::size_t { Sobol, Independent };
constexpr std::array<std::string_view, 2> PointNames = {"sobol", "independent"};

/// A relative error, root mean square over repeats (and views), with its uncertainty.
struct Error {
  double square = 0;    ///< the mean of its square
  double variance = 0;  ///< of that mean

  double value() const;
  /// The standard error of `value`, relative to it.
  double noise() const;
};

/// Averages errors with equal weights, such as those of several views.
template <class Errors, class ErrorOf>
Error mean_of(const Errors& errors, const ErrorOf& error_of) {
  Error mean;
  for (const auto& one : errors) {
    const Error error = error_of(one);
    mean.square += error.square;
    mean.variance += error.variance;
  }
  const auto count = static_cast<double>(errors.size());
  mean.square /= count;
  mean.variance /= count * count;
  return mean;
}

/// The errors per light and number of samples.
using Errors = std::array<std::array<Error, SampleCounts.size()>, LightCount>;

/// Estimates with all numbers of samples and repeats with other points. There are more repeats for fewer
/// samples, `repeats` for 256.
Errors measure_errors(const Technique& technique, const Setting& setting, Points points, int repeats);

}  // namespace study
