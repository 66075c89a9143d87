// The exponent of a cosine lobe is fitted to a BRDF, which the thesis did by hand.
#pragma once

#include "samples/studies/sampling/technique.h"

namespace study {

/// Returns the total variation distance between the pdf of the scheme `hemisphere` of this exponent and the
/// ideal one: half the integral of |pdf - f cos / albedo|, mean over views at 20, 45 and 70 degrees.
double total_variation_distance(const reflectance::Brdf& brdf, double exponent);

/// Returns the exponent of least distance, among 16 between 0.5 and 1000.
double best_lobe_exponent(const reflectance::Brdf& brdf);

}  // namespace study
