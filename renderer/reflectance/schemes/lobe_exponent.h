#pragma once

#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// The value of a scheme's exponent that is not given: below 0.
constexpr float OwnExponent = -1;

/// The half-vector exponents for a BRDF without a cosine lobe: as wide as Gaussian slopes of 0.22.
constexpr LobeExponents PlainExponents = {40, 40};

/// Returns the BRDF's own exponents, or `PlainExponents`.
inline LobeExponents own_exponents(const Brdf& brdf) { return lobe_exponents(brdf).value_or(PlainExponents); }

}  // namespace reflectance
