#include "renderer/reflectance/even_points.h"

#include <algorithm>

namespace reflectance {
namespace {

/// Computes the radical inverse: the digits of the index, mirrored at the point.
float mirrored_digits(std::uint32_t index, std::uint32_t base) {
  double value = 0;
  for (double place = 1.0 / base; index > 0; place /= base, index /= base) value += place * (index % base);
  return std::min(static_cast<float>(value), 0x1.fffffep-1F);
}

}  // namespace

Uniforms even_point(std::uint32_t index) {
  ++index;  // index 0 is 0 in all coordinates
  return {{mirrored_digits(index, 2), mirrored_digits(index, 3)}, mirrored_digits(index, 5)};
}

}  // namespace reflectance
