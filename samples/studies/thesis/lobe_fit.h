// Which exponent of a cosine lobe comes nearest to a BRDF: what the thesis adjusted by hand.
#pragma once

#include "samples/studies/sampling/technique.h"

namespace study {

/// The share of directions that the scheme `hemisphere` of that exponent draws elsewhere than it should: half
/// the integral of |density - f cos / albedo|, in the mean over views at 20, 45 and 70 degrees.
double lobe_distance(const reflectance::Brdf& brdf, double exponent);

/// The one of least distance, of some between 0.5 and 1000.
double best_lobe_exponent(const reflectance::Brdf& brdf);

}  // namespace study
