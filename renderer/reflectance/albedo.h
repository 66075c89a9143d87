#pragma once

#include "renderer/reflectance/reflector.h"

namespace reflectance {

/// The share of light from u that is reflected (or, as models are reciprocal or not, of uniform light that is
/// reflected towards u): the integral of f cos(theta_v), Dirac part included. By points that fill space
/// evenly, through the reflector's own sampling, so that narrow lobes cost no more than wide ones. The error
/// is about 1 / count where weights are smooth.
Rgb albedo(const Reflector& reflector, const Vec3f& u, int count = 8192);

/// The `index`-th of the points that fill the unit cube evenly: an additive recurrence by powers of the
/// inverse of the root of x^4 = x + 1 (Roberts 2018, "The unreasonable effectiveness of quasirandom
/// sequences").
Uniforms even_point(std::uint32_t index);

}  // namespace reflectance
