// Observations and fits for tests.
#pragma once

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include "renderer/fit/fit.h"
#include "tests/reflectance/brdf_cases.h"

namespace test {

/// Returns observations of a BRDF that is written as in `brdf_of`.
inline fit::Observations observations_of(const std::string& brdf, std::size_t count) {
  grf::Diagnostics diagnostics;
  auto observations = usable(fit::sampled(brdf_of(brdf), count, diagnostics), "", diagnostics);
  if (!observations) throw std::runtime_error(diagnostics.to_text());
  return *observations;
}

inline fit::Fit fit_of(const std::string& target, const fit::Observations& observations,
                       const fit::FitSettings& settings = {}) {
  grf::Diagnostics diagnostics;
  const auto targets = fit::targets_of(target, 1);
  auto fit = fit_brdf(targets.value().at(0), observations, settings, diagnostics);
  if (!fit) throw std::runtime_error(diagnostics.to_text());
  return *std::move(fit);
}

/// Returns the first parameter of that name, of a channel if it has any.
inline const fit::FittedParameter& parameter(const fit::Fit& fit, const std::string& name, int channel = 0) {
  for (const fit::FittedParameter& one : fit.parameters) {
    if (one.name == name && one.channel.value_or(channel) == channel) return one;
  }
  throw std::runtime_error("no parameter " + name);
}

/// Multiplies values by 1 plus normal noise, equal for the channels.
inline void add_noise(fit::Observations& observations, double deviation, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(1, deviation);
  for (fit::Observation& one : observations.list) one.value *= normal(random);
}

}  // namespace test
