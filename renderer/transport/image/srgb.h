#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace transport {

/// The linear values of sRGB-encoded bytes (IEC 61966-2-1), white being 1.
using SrgbTable = std::array<float, 256>;

inline const SrgbTable& srgb_table() {
  static const SrgbTable table = [] {
    SrgbTable linear = {};
    for (std::size_t i = 0; i < linear.size(); ++i) {
      const double encoded = static_cast<double>(i) / 255;
      linear[i] =
          static_cast<float>(encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
    }
    return linear;
  }();
  return table;
}

/// The byte whose value is nearest in sRGB's own measure: 255 from 1 on, and 0 for what is no number.
inline std::uint8_t to_srgb_byte(float linear) {
  if (!(linear > 0)) return 0;
  const float value = std::min(linear, 1.0F);
  const float encoded = value <= 0.0031308F ? 12.92F * value : 1.055F * std::pow(value, 1 / 2.4F) - 0.055F;
  return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

}  // namespace transport
