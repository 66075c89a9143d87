// A fit finds the parameters of a BRDF model, or of a sum of models, that are nearest to data.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "grf/model.h"
#include "renderer/fit/metric.h"
#include "renderer/fit/observations.h"
#include "renderer/reflectance/brdf.h"

namespace fit {

/// A target of a fit has the keyword of a model, or those of the terms of a sum.
struct Target {
  std::vector<std::string> keywords;

  /// Returns the keyword, or `combine ward ward`.
  std::string name() const;
};

/// Parses `ward,ggx,combine ggx eon`. A model on its own is repeated `lobes` times, as a sum. Nothing if a
/// target is empty.
std::optional<std::vector<Target>> targets_of(const std::string& text, std::size_t lobes);

struct FitSettings {
  Metric metric = Metric::CubeRoot;
  std::vector<grf::Argument> fixed;  ///< values of parameters, for the models that have them
  int threads = 0;                   ///< 0: one per core
};

/// A parameter of a fit with its interval of 95 % confidence.
struct FittedParameter {
  std::size_t term = 0;        ///< the term of the sum that has it
  std::string name;            ///< `weight` is the factor of a term
  std::optional<int> channel;  ///< of a colour whose channels differ
  double value = 0;
  double low = 0;
  double high = 0;
  bool is_determined =
      true;                  ///< the data determine it: see Uncertainty, or the interval is half of the range
  bool is_at_bound = false;  ///< at an end of its range, where there is no interval
};

/// Differences in one metric, root mean squares.
struct FitError {
  double absolute = 0;
  double relative = 0;  ///< over that of the data's own values in the metric
};

struct FitTerm {
  double weight = 1;
  grf::BrdfModel model;
};

struct Fit {
  Target target;
  std::vector<FitTerm> terms;
  reflectance::Brdf brdf;
  std::vector<FittedParameter> parameters;
  std::vector<std::string> held;                ///< parameters that kept their defaults, and why
  std::vector<std::string> warnings;            ///< what is wrong with the result, sentences
  std::array<FitError, Metrics.size()> errors;  ///< in each metric
  double seconds = 0;

  const FitError& error(Metric metric) const { return errors[static_cast<std::size_t>(metric)]; }
};

/// Fits a target to observations that are `usable`; returns nothing after an error. The result depends on
/// neither the time nor the number of threads. Shapes are scanned and the best 48 starts refined on up to 128
/// of the observations, the best twelve of these on up to 400, and the best two on all.
std::optional<Fit> fit_brdf(const Target& target, const Observations& observations,
                            const FitSettings& settings, grf::Diagnostics& diagnostics);

/// Returns the GRF text of a fit: an instance, or for a sum a scene that defines `fit`, which is read as
/// `FILE:fit`.
std::string text_of(const Fit& fit);

/// Returns the place of the fits in the order of their errors in a metric, the best one first.
std::vector<std::size_t> ranking(const std::vector<Fit>& fits, Metric metric);

}  // namespace fit
