#pragma once

#include "renderer/reflectance/reflector.h"

namespace reflectance {

/// Computes the directional albedo for a view u, the integral of f cos(theta_v) with the delta part.
/// Integrates by quasi-Monte Carlo through the reflector's own importance sampling, so that narrow lobes cost
/// no more than wide ones. The error falls nearly as 1 / count; by default it is within 0.002.
Rgb albedo(const Reflector& reflector, const Vec3f& u, int count = 16384);

/// Returns the largest directional albedo over channels and some view angles up to 85 degrees. It is cheap,
/// and accurate to 0.01 where it exceeds 1.
grf::LargestAlbedo largest_albedo(const Brdf& brdf);

}  // namespace reflectance
