#pragma once

#include <bit>
#include <cstdint>

#include "renderer/reflectance/schemes/split_mix.h"

namespace studies {

/// Returns the random numbers of a seed: independent ones, since a low-discrepancy sequence is no good for
/// rejection, where the number of tries is random.
inline reflectance::SplitMix random_numbers(std::uint32_t seed) {
  return reflectance::SplitMix({{std::bit_cast<float>(seed), 0.5F}, 0.25F});
}

}  // namespace studies
