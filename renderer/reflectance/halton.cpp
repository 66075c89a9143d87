#include "renderer/reflectance/halton.h"

#include <algorithm>

namespace reflectance {
namespace {

/// Computes the radical inverse: the digits of the index, mirrored at the point.
float radical_inverse(std::uint32_t index, std::uint32_t base) {
  double value = 0;
  for (double place = 1.0 / base; index > 0; place /= base, index /= base) value += place * (index % base);
  return std::min(static_cast<float>(value), 0x1.fffffep-1F);
}

}  // namespace

Uniforms halton_point(std::uint32_t index) {
  ++index;  // index 0 is 0 in all coordinates
  return {{radical_inverse(index, 2), radical_inverse(index, 3)}, radical_inverse(index, 5)};
}

}  // namespace reflectance
