#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "grf/srgb.h"

namespace image {

/// The linear values of sRGB-encoded bytes (IEC 61966-2-1); 255 is 1.
using SrgbTable = std::array<float, 256>;

inline const SrgbTable& srgb_table() {
  static const SrgbTable table = [] {
    SrgbTable linear = {};
    for (std::size_t i = 0; i < linear.size(); ++i) {
      linear[i] = static_cast<float>(grf::srgb_decoded(static_cast<double>(i) / 255));
    }
    return linear;
  }();
  return table;
}

/// Returns the nearest byte in sRGB encoding: 255 from 1 on, and 0 for NaN.
inline std::uint8_t to_srgb_byte(float linear) {
  if (!(linear > 0)) return 0;
  return static_cast<std::uint8_t>(std::lround(255 * grf::srgb_encoded(std::min(linear, 1.0F))));
}

}  // namespace image
