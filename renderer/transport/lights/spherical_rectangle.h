#pragma once

#include "renderer/transport/lights/spherical_triangle.h"

namespace transport {

/// A rectangle projected to the unit sphere about the origin, to be sampled uniformly by solid angle and
/// along its sides (Urena, Fajardo and King 2013, "An area-preserving parametrization for spherical
/// rectangles").
///
/// The solid angle up to x is G(x) - G(x0), with G(x) = asin(b1 c) - asin(b0 c), c = x / sqrt(x^2 + z^2) and
/// b the same of y0 and y1. Sines and cosines of G are known without the angle, so one arc tangent, one sine
/// and one cosine replace the paper's four arc cosines. The loss of accuracy grows as the rectangle becomes
/// tiny: such ones are sampled as two triangles.
class SphericalRectangle {
 public:
  /// The edges must be perpendicular.
  SphericalRectangle(const Vec3d& corner, const Vec3d& edge1, const Vec3d& edge2);

  /// 0 from behind and from a corner.
  float solid_angle() const { return solid_angle_; }

  /// Samples a point as multiples of edge1 and edge2, with solid-angle pdf 1 / solid_angle().
  Vec2d sample(const Vec2f& xi) const;

 private:
  /// Rectangles of smaller solid angle are sampled as triangles.
  static constexpr float Small = 1e-8F;

  double x_for(float part) const;
  double y_for(double x, double xi) const;

  Vec3d corner_, edge1_, edge2_;
  double width_, height_;  ///< lengths of the edges
  double x0_, y0_, z_;     ///< the corner along the edges, and the plane's distance
  double r00_ = 0;         ///< the corners' distances, indexed by x, then y
  double r01_ = 0;
  float solid_angle_ = 0;
};

}  // namespace transport
