#pragma once

#include <bit>
#include <cstdint>

#include "renderer/reflectance/model.h"

namespace reflectance {

/// A random number generator seeded by the bits of a `Uniforms`, for loops that need any number of uniform
/// numbers. The same xi gives the same numbers (Steele, Lea and Flood 2014, "Fast splittable pseudorandom
/// number generators").
class SplitMix {
 public:
  explicit SplitMix(const Uniforms& xi) {
    for (const float number : {xi.direction.x, xi.direction.y, xi.choice}) {
      state_ = mixed(state_ + std::bit_cast<std::uint32_t>(number));
    }
  }

  /// Returns the next number in [0,1).
  double next() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }
  Vec2f next_pair() {
    const std::uint64_t both = bits();
    return {static_cast<float>(both >> 40U) * 0x1p-24F,
            static_cast<float>((both >> 8U) & 0xFFFFFFU) * 0x1p-24F};
  }

 private:
  static constexpr std::uint64_t Step = 0x9E3779B97F4A7C15U;

  static std::uint64_t mixed(std::uint64_t bits) {
    bits += Step;
    bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
    bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
    return bits ^ (bits >> 31U);
  }
  std::uint64_t bits() {
    const std::uint64_t result = mixed(state_);
    state_ += Step;
    return result;
  }

  std::uint64_t state_ = 0;
};

}  // namespace reflectance
