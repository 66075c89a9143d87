#pragma once

#include <cmath>

#include "renderer/reflectance/geometry.h"

namespace reflectance {

/// The rotation about the normal that takes a view u into the plane y = 0, x >= 0. Tables are relative to it:
/// those of isotropic BRDFs cover only that plane, and lobes stay at the mirror direction.
class AzimuthRotation {
 public:
  AzimuthRotation() = default;
  explicit AzimuthRotation(const Vec3f& u) {
    const float radius = std::sqrt(u.x * u.x + u.y * u.y);
    if (!(radius > 0)) return;
    cosine_ = u.x / radius;
    sine_ = u.y / radius;
  }
  /// Makes the rotation for views at the azimuth with that cosine and sine.
  AzimuthRotation(float cosine, float sine) : cosine_(cosine), sine_(sine) {}

  Vec3f to_plane(const Vec3f& w) const {
    return {cosine_ * w.x + sine_ * w.y, cosine_ * w.y - sine_ * w.x, w.z};
  }
  Vec3f from_plane(const Vec3f& w) const {
    return {cosine_ * w.x - sine_ * w.y, cosine_ * w.y + sine_ * w.x, w.z};
  }

 private:
  float cosine_ = 1;
  float sine_ = 0;
};

}  // namespace reflectance
