// How well a pdf matches a BRDF, by quadrature, and the search for the best parameters.
#pragma once

#include <vector>

#include "samples/studies/sampling/cases.h"
#include "samples/studies/sampling/technique.h"

namespace study {

/// The fit of a pdf, averaged over the views.
struct Fit {
  /// The total variation distance, half the integral of |pdf - f cos / albedo|, 0 to 1.
  double distance = 0;
  /// The relative error of one independent sample under a constant environment, from the variance of f cos /
  /// pdf.
  double deviation = 0;
};

/// Evaluates the BRDF once for all pdfs.
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

/// Returns the exponent of `hemisphere` or `sphere` of least deviation, of 1, 2, 5, 10 and so on to 1000.
double best_exponent(const std::string& scheme, const reflectance::Brdf& brdf, const FitMeter& meter);

struct FactorFit {
  FactorParameters parameters;
  double distance = 0;
};

/// Searches the best factorisation: all J and K up to `most_factors`, directions and half vectors, the
/// resolutions of table 5.6 and a finer one in theta. Returns the one with the smallest tables within 2 % of
/// the best.
FactorFit best_factors(const reflectance::Brdf& brdf, const FitMeter& meter, int most_factors);

}  // namespace study
