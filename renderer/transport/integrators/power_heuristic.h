#pragma once

namespace transport {

/// The weight of a sample that was drawn with the first density and could have been drawn with the other one
/// (Veach and Guibas 1995, power heuristic with exponent 2).
inline float power_heuristic(float density, float other) {
  // In terms of the ratio, which overflows to a right answer where squares would not.
  const float ratio = other / density;
  return 1 / (1 + ratio * ratio);
}

}  // namespace transport
