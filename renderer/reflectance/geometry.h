// Directions are given in the local frame (z along the normal), and these functions sample them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grf/math.h"

namespace reflectance {

using grf::Vec2f;
using grf::Vec3f;

/// A linear RGB reflectance, BRDF value or weight.
using Rgb = Imath::V3f;

constexpr float Pi = std::numbers::pi_v<float>;  ///< The circle constant.

/// Returns the mean, or the largest, of the channels.
inline float mean(const Rgb& rgb) { return (rgb.x + rgb.y + rgb.z) / 3; }
inline float largest(const Rgb& rgb) { return std::max({rgb.x, rgb.y, rgb.z}); }
/// The luminance of linear sRGB. In double: three channels near the largest float sum to more.
inline double luminance(const Rgb& rgb) {
  return 0.2126 * double(rgb.x) + 0.7152 * double(rgb.y) + 0.0722 * double(rgb.z);
}
/// Returns whether no channel is positive.
inline bool is_black(const Rgb& rgb) { return rgb.x <= 0 && rgb.y <= 0 && rgb.z <= 0; }

/// Returns the mirror direction of u.
inline Vec3f mirrored(const Vec3f& u) { return {-u.x, -u.y, u.z}; }

/// Reflects u at a microfacet whose normal is h. The result is a unit vector if both are.
inline Vec3f reflected(const Vec3f& u, const Vec3f& h) { return 2 * u.dot(h) * h - u; }

/// Returns u.h = v.h, where h is the unit half vector of u and v.
inline float cosine_of_half(const Vec3f& u, const Vec3f& v) { return (u + v).length() / 2; }

/// Returns the direction with that cosine and sine of the polar angle, at azimuth phi.
inline Vec3f from_angles(float cosine, float sine, float phi) {
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

/// Samples a direction with pdf (n+1)/(2 pi) cos(theta)^n. Computes 1 - cos, so that n = 1e6 keeps its shape.
inline Vec3f power_direction(float n, const Vec2f& xi) {
  const float one_minus_cos = -std::expm1(std::log1p(-xi.x) / (n + 1));
  const float sine = std::sqrt(one_minus_cos * (2 - one_minus_cos));
  return from_angles(1 - one_minus_cos, sine, 2 * Pi * xi.y);
}

/// An orthonormal basis about a unit vector, without the cancellation of a cross product with a fixed axis
/// (Duff, Burgess, Christensen, Hery, Kensler, Liani and Villemin 2017, "Building an orthonormal basis,
/// revisited").
struct Frame {
  Vec3f x, y, z;

  explicit Frame(const Vec3f& normal) : z(normal) {
    const float sign = std::copysign(1.0F, z.z);
    const float a = -1 / (sign + z.z);
    const float b = z.x * z.y * a;
    x = {1 + sign * z.x * z.x * a, sign * b, -sign * z.x};
    y = {b, sign + z.y * z.y * a, -z.y};
  }

  /// Makes a frame with x along the tangent's projection, or any x if the tangent is 0 or parallel to the
  /// normal.
  Frame(const Vec3f& normal, const Vec3f& tangent) : Frame(normal) {
    const Vec3f along = tangent - normal * normal.dot(tangent);
    if (!(along.length2() > 1e-12F * tangent.length2())) return;
    x = along.normalized();
    y = z.cross(x);
  }

  /// Converts directions between the world and the frame.
  Vec3f to_local(const Vec3f& world) const { return {world.dot(x), world.dot(y), world.dot(z)}; }
  Vec3f to_world(const Vec3f& local) const { return local.x * x + local.y * y + local.z * z; }
};

/// Sine and cosine of an angle from -pi/4 to pi/4, within 1 ulp. Made for a path's inner loop, where the
/// range reduction of the library functions would cost more than the series.
struct SineAndCosine {
  float sine, cosine;

  explicit SineAndCosine(float angle) {
    const float x2 = angle * angle;
    sine = angle * (1 + x2 * (-1.0F / 6 + x2 * (1.0F / 120 + x2 * (-1.0F / 5040 + x2 * (1.0F / 362880)))));
    cosine = 1 + x2 * (-0.5F + x2 * (1.0F / 24 + x2 * (-1.0F / 720 + x2 * (1.0F / 40320))));
  }
};

/// A point of the unit disc.
struct DiscPoint {
  Vec2f point;
  float height2 = 1;  ///< squared height of the unit hemisphere above the point
};

/// Maps two uniform numbers in [0,1) to the unit disc by concentric mapping, which keeps areas and
/// neighbourhoods (Shirley and Chiu 1997, "A low distortion map between disk and square"). Stays just inside
/// the rim, where the height is 0.
inline DiscPoint disc_point(const Vec2f& xi) {
  constexpr float Rim = 1 - 0x1p-24F;
  const float a = 2 * xi.x - Rim;
  const float b = 2 * xi.y - Rim;
  const bool wide = std::abs(a) > std::abs(b);
  const float radius = wide ? a : b;
  if (radius == 0) return {Vec2f(0), 1};
  const SineAndCosine turn(Pi / 4 * (wide ? b : a) / radius);
  const Vec2f direction = wide ? Vec2f(turn.cosine, turn.sine) : Vec2f(turn.sine, turn.cosine);
  return {radius * direction, (1 - radius) * (1 + radius)};
}
inline Vec2f to_disc(const Vec2f& xi) { return disc_point(xi).point; }  ///< Returns the point only.

/// Samples a direction with pdf cos(theta)/pi.
inline Vec3f cosine_direction(const Vec2f& xi) {
  const auto [point, height2] = disc_point(xi);
  return {point.x, point.y, std::sqrt(height2)};
}
/// Samples a direction with the uniform pdf 1/(2 pi) over the hemisphere.
inline Vec3f uniform_direction(const Vec2f& xi) {
  return from_angles(1 - xi.x, std::sqrt(xi.x * (2 - xi.x)), 2 * Pi * xi.y);
}
/// Returns the pdf of `cosine_direction`, per solid angle.
inline float cosine_pdf(const Vec3f& v) { return std::max(0.0F, v.z) / Pi; }

}  // namespace reflectance
