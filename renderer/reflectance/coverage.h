#pragma once

#include "renderer/reflectance/scheme.h"

namespace reflectance {

/// Returns the largest fraction of reflected light, 0 to 1 over view angles, that a scheme with its tables
/// samples never or so rarely that an estimate would converge to a wrong value: where f cos / pdf exceeds 100
/// times the albedo.
float missed_fraction(const Scheme& scheme, const Brdf& brdf);

}  // namespace reflectance
