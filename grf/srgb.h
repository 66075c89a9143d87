#pragma once

#include <cmath>

#include "grf/math.h"

namespace grf {

/// The sRGB transfer function (IEC 61966-2-1), from linear values to those of 8-bit files and screens. Both
/// are from 0 to 1, in float or double.
template <class Number>
Number srgb_encoded(Number linear) {
  if (linear <= Number(0.0031308)) return Number(12.92) * linear;
  return Number(1.055) * std::pow(linear, 1 / Number(2.4)) - Number(0.055);
}

/// The inverse sRGB transfer function.
template <class Number>
Number srgb_decoded(Number encoded) {
  if (encoded <= Number(0.04045)) return encoded / Number(12.92);
  return std::pow((encoded + Number(0.055)) / Number(1.055), Number(2.4));
}

/// Decodes the channels of a colour.
inline Colour srgb_decoded(const Colour& encoded) {
  return {srgb_decoded(encoded.x), srgb_decoded(encoded.y), srgb_decoded(encoded.z)};
}

}  // namespace grf
