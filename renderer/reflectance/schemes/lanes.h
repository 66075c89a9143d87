// SIMD intrinsics select values without branches. Branches on random numbers are unpredictable, and compilers
// turn conditions into branches; hence intrinsics, of the baseline instruction set (cmake/options.cmake).
#pragma once

#include <immintrin.h>

namespace reflectance {

/// Four floats in one register, or one float four times.
using Lanes = __m128;

/// Returns lanes A to D, in this order.
template <int A, int B, int C, int D>
Lanes lanes_of(Lanes lanes) {
  return _mm_permute_ps(lanes, A | (B << 2) | (C << 4) | (D << 6));
}

/// Returns `greater` if a > b, else `otherwise`.
inline float if_greater(float a, float b, float greater, float otherwise) {
  const Lanes is_greater = _mm_cmpgt_ss(_mm_set_ss(a), _mm_set_ss(b));
  return _mm_cvtss_f32(_mm_blendv_ps(_mm_set_ss(otherwise), _mm_set_ss(greater), is_greater));
}

}  // namespace reflectance
