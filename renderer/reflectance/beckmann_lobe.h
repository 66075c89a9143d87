// Beckmann's microfacet distribution (Gaussian slopes) is importance sampled here for the models that use it.
#pragma once

#include <cmath>

#include "renderer/reflectance/geometry.h"

namespace reflectance {

/// Reflects u at a microfacet whose slopes along x and y are Gaussian, with rms ax/sqrt(2) and ay/sqrt(2).
inline Vec3f beckmann_direction(const Vec3f& u, float ax, float ay, const Vec2f& xi) {
  const float psi = 2 * Pi * xi.y;
  const float radius = std::sqrt(-std::log1p(-xi.x));
  const Vec3f h(ax * radius * std::cos(psi), ay * radius * std::sin(psi), 1);
  return reflected(u, h.normalized());
}

/// Returns its solid-angle pdf, D cos(theta_h) / (4 u.h).
inline float beckmann_pdf(const Vec3f& u, const Vec3f& v, float ax, float ay) {
  const Vec3f h = u + v;
  const float x = h.x / (ax * h.z);
  const float y = h.y / (ay * h.z);
  const float cosine = h.z / h.length();
  return std::exp(-(x * x + y * y)) / (4 * Pi * ax * ay * cosine_of_half(u, v) * cosine * cosine * cosine);
}

}  // namespace reflectance
