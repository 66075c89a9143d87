// The measurements of one BRDF.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "samples/studies/sampling/cases.h"
#include "samples/studies/sampling/costs.h"
#include "samples/studies/sampling/errors.h"
#include "samples/studies/sampling/fit.h"

namespace study {

/// The effort of the measurements.
struct Effort {
  bool is_quick = false;
  int repeats = 1024;    ///< of estimates with 256 samples
  int builds = 3;        ///< for timing tables
  int rounds = 40;       ///< of 8,192 samples
  int resolution = 800;  ///< of the grid of `mode=reject`
  int most_factors = 4;  ///< largest J and K of the search

  static Effort quick() { return {true, 64, 1, 8, 64, 2}; }
};

/// The thesis' five techniques, two more generic ones, and the model's own. Exponents are 50, or adjusted to
/// the BRDF.
enum TechniqueId : std::size_t {
  Diffuse,
  Sphere50,
  SphereBest,
  Hemisphere50,
  HemisphereBest,
  Factored,
  Cascade,
  Reject,
  Warp,
  Own
};
constexpr std::array<std::string_view, 10> TechniqueNames = {
    "diffuse",  "sphere-50", "sphere-best", "hemisphere-50", "hemisphere-best",
    "factored", "cascade",   "reject",      "warp",          "own"};

struct TechniqueResult {
  std::string scheme;  ///< GRF text; `own` for the model's own sampler
  double cosine_fraction = 0;
  double build_seconds = 0;
  std::size_t bytes = 0;
  SampleCost cost;
  Fit fit;
  std::array<std::array<Errors, ViewDegrees.size()>, PointNames.size()> errors;

  /// Returns the root mean square over the views.
  Error error(Light light, Points points, std::size_t count) const {
    return mean_of(errors[points], [&](const Errors& of_view) { return of_view[light][count]; });
  }
};

struct CaseResult {
  const Case* subject = nullptr;
  TableCost reject_60, reject_90, warp_60, warp_90;  ///< with one azimuth, `reject` without its tables
  TableCost factored, factored_found;                ///< with the parameters of table 5.6, and those found
  double factored_distance = 0;
  FactorFit found;
  std::array<std::size_t, TriesOfTable.size()> tree_bytes = {};
  std::array<TechniqueResult, TechniqueNames.size()> techniques;
  /// The error of one independent sample with a perfect pdf, root mean square over the views.
  std::array<double, LightCount> perfect = {};

  const TechniqueResult& operator[](TechniqueId id) const { return techniques[id]; }

  bool is_glossy = false;  ///< the model has a lobe
};

struct Results {
  Effort effort;
  std::string command;
  std::string machine;
  std::vector<CaseResult> cases;
};

CaseResult measure(const Case& subject, const Effort& effort);

}  // namespace study
