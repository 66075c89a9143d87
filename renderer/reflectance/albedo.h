#pragma once

#include "renderer/reflectance/reflector.h"

namespace reflectance {

/// The share of light from u that is reflected (or, as models are reciprocal or not, of uniform light that is
/// reflected towards u): the integral of f cos(theta_v), Dirac part included. By points that fill space
/// evenly, through the reflector's own sampling, so that narrow lobes cost no more than wide ones. The error
/// falls nearly as 1 / count; by default it is within 0.002.
Rgb albedo(const Reflector& reflector, const Vec3f& u, int count = 16384);

/// What a BRDF reflects at most, over its channels and some angles up to 85 degrees: cheap, and right within
/// a hundredth where it is over 1.
grf::LargestAlbedo largest_albedo(const Brdf& brdf);

}  // namespace reflectance
