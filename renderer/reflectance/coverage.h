#pragma once

#include "renderer/reflectance/scheme.h"

namespace reflectance {

/// The largest share of the light that a BRDF reflects, over view angles, which a scheme with its tables
/// draws never, or so rarely that an estimate that lacks it would be taken for right: where f cos / density
/// is over 100 times the albedo. 0 to 1.
float missed_share(const Scheme& scheme, const Brdf& brdf);

}  // namespace reflectance
