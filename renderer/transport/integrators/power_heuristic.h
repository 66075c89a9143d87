#pragma once

namespace transport {

/// The MIS weight of a sample drawn with the first pdf that the strategy with the other pdf could have drawn
/// (Veach and Guibas 1995, power heuristic with exponent 2).
inline float power_heuristic(float pdf, float other) {
  // In terms of the ratio, which overflows to a right answer where squares would not.
  const float ratio = other / pdf;
  return 1 / (1 + ratio * ratio);
}

}  // namespace transport
