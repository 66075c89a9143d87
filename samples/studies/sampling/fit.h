// How well a density follows a BRDF, by quadrature, and what parameters follow it best.
#pragma once

#include <vector>

#include "samples/studies/sampling/cases.h"
#include "samples/studies/sampling/technique.h"

namespace study {

/// Means over the views.
struct Fit {
  /// Half the integral of |density - f cos / albedo|: the share of samples that go elsewhere than they
  /// should, 0 to 1.
  double distance = 0;
  /// The relative error of one independent sample under light from everywhere, by the variance of
  /// f cos / density.
  double deviation = 0;
};

/// The values of a BRDF, once for all densities.
class FitMeter {
 public:
  explicit FitMeter(const reflectance::Brdf& brdf);

  Fit fit_of(const Technique& technique) const;

 private:
  struct ViewValues {
    reflectance::Vec3f u;
    std::vector<float> shares;  ///< f cos / albedo at the points of the quadrature
  };
  std::vector<ViewValues> views_;
};

/// The exponent of `hemisphere` or `sphere` of least deviation, of 1, 2, 5, 10 and so on to 1000.
double best_exponent(const std::string& scheme, const reflectance::Brdf& brdf, const FitMeter& meter);

struct FactorFit {
  FactorParameters parameters;
  double distance = 0;
};

/// The factorisation that fits best: all J and K up to `most_factors`, of directions and half vectors, of the
/// resolutions of table 5.6 and one finer in theta. Of those that are within a fiftieth of the best, the one
/// with the smallest tables.
FactorFit best_factors(const reflectance::Brdf& brdf, const FitMeter& meter, int most_factors);

}  // namespace study
