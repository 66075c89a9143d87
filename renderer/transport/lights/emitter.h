#pragma once

#include "grf/math.h"
#include "renderer/reflectance/geometry.h"

namespace transport {

using grf::Colour;
using grf::Vec2f;
using grf::Vec3f;
using reflectance::Rgb;

/// An emitting parallelogram, or the triangle that is half of it. It emits from its front, the side to which
/// edge1 x edge2 points.
struct Emitter {
  Vec3f corner;
  Vec3f edge1;
  Vec3f edge2;
  bool is_triangle = false;
  Rgb radiance;  ///< W/(sr m2), times its opacity if that is constant

  Vec3f doubled_area_normal() const { return edge1.cross(edge2); }
  float area() const { return doubled_area_normal().length() / (is_triangle ? 2 : 1); }
  /// Area times mean radiance: the power in watts, but for a factor of pi.
  float power() const { return area() * reflectance::mean(radiance); }
};

}  // namespace transport
