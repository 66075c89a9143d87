// C++ gets the functions and types of GLSL 3.30 that formulas may use, under GLSL's names, in float and in
// double. glsl_functions.glsl is the other half. A formula is a struct of this namespace whose template
// parameter is called `real`, with `vec3` and `PI` beside it, that includes common.glsl and the model's text
// as its member functions.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include <ImathVec.h>

namespace reflectance::glsl {

// NOLINTBEGIN(readability-identifier-naming): GLSL's names
inline int floatBitsToInt(float x) { return std::bit_cast<std::int32_t>(x); }
inline float intBitsToFloat(int x) { return std::bit_cast<float>(x); }
// NOLINTEND(readability-identifier-naming)

using std::abs;
using std::exp;
using std::floor;
using std::sqrt;

template <class Real>
Real min(Real a, Real b) {
  return a < b ? a : b;
}
template <class Real>
Real max(Real a, Real b) {
  return a > b ? a : b;
}
template <class Real>
Imath::Vec3<Real> min(const Imath::Vec3<Real>& a, Real b) {
  return {min(a.x, b), min(a.y, b), min(a.z, b)};
}
template <class Real>
Imath::Vec3<Real> max(const Imath::Vec3<Real>& a, Real b) {
  return {max(a.x, b), max(a.y, b), max(a.z, b)};
}

/// Functions that GLSL lacks or computes with too few digits. In float, C++ and GLSL both run this text.
struct FloatFunctions {
  using real = float;
#include "renderer/reflectance/float_functions.glsl"
};

inline float log(float x) { return FloatFunctions().log_of(x); }
inline double log(double x) { return std::log(x); }
inline float log1p(float x) { return FloatFunctions().log1p_of(x); }
inline double log1p(double x) { return std::log1p(x); }
inline float expm1(float x) { return FloatFunctions().expm1_of(x); }
inline double expm1(double x) { return std::expm1(x); }
inline float erfc(float x) { return FloatFunctions().erfc_of(x); }
inline double erfc(double x) { return std::erfc(x); }
inline float sin(float x) { return FloatFunctions().sin_of(x); }
inline double sin(double x) { return std::sin(x); }
inline float cos(float x) { return FloatFunctions().cos_of(x); }
inline double cos(double x) { return std::cos(x); }
inline float atan2(float y, float x) { return FloatFunctions().atan2_of(y, x); }
inline double atan2(double y, double x) { return std::atan2(y, x); }

template <class real>
constexpr real Pi = real(3.14159265358979323846L);

}  // namespace reflectance::glsl
