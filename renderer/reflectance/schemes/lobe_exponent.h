#pragma once

#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// What an exponent of a scheme is when none is given: below 0.
constexpr float OwnExponent = -1;

/// Of a BRDF without a cosine lobe, about the half vector: as wide as Gaussian slopes of 0.22.
constexpr LobeExponents PlainExponents = {40, 40};

/// The BRDF's own exponents, or the plain ones.
inline LobeExponents own_exponents(const Brdf& brdf) { return lobe_exponents(brdf).value_or(PlainExponents); }

}  // namespace reflectance
