// Eight floats in a vector register (SIMD), by the standard library's Parallelism TS 2.
#pragma once

#include <experimental/simd>

namespace transport {

/// Eight floats. Each operation is rounded as that of a float alone, so that results have the same bits.
using Float8 = std::experimental::native_simd<float>;
static_assert(Float8::size() == 8, "the baseline of cmake/options.cmake has vector registers of 8 floats");

inline Float8 square_root(const Float8& value) { return std::experimental::sqrt(value); }
inline Float8 magnitude(const Float8& value) { return std::experimental::abs(value); }
inline Float8 larger(const Float8& a, const Float8& b) { return std::experimental::max(a, b); }

/// Returns `yes` in the lanes where the condition holds, and `no` in the others.
inline Float8 select(const Float8::mask_type& condition, const Float8& yes, Float8 no) {
  where(condition, no) = yes;
  return no;
}

}  // namespace transport
