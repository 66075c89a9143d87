#pragma once

#include "grf/math.h"

namespace transport {

using grf::Vec2d;
using grf::Vec2f;
using grf::Vec3d;

/// The angle of (x, y) from the x axis, -pi..pi, with the relative accuracy of a float, however small the
/// angle.
float angle_of(double y, double x);

/// A triangle projected to the unit sphere about the origin, to be sampled uniformly by solid angle (Arvo
/// 1995, "Stratified sampling of spherical triangles").
///
/// The formulas are those of half the solid angle (Van Oosterom and Strackee 1983, "The solid angle of a
/// plane triangle"; Peters 2021, "BRDF importance sampling for polygonal lights"), which need one arc
/// tangent, one sine and one cosine and have no cancellation: as a triangle becomes tiny they turn into those
/// of area sampling, without a switch. Sums and products are in double, since they cost the same as in float.
class SphericalTriangle {
 public:
  /// The corners relative to the origin. `volume` is det(pivot, first, last), over 0 from the front; a caller
  /// knows it more accurately than it could be computed from differences of unit vectors.
  SphericalTriangle(const Vec3d& pivot, const Vec3d& first, const Vec3d& last, double volume);
  /// The triangle of corner, corner + edge1 and corner + edge2; empty unless its front, to which edge1 x
  /// edge2 points, faces the origin.
  SphericalTriangle(const Vec3d& corner, const Vec3d& edge1, const Vec3d& edge2);

  /// 0 from behind and from a corner.
  float solid_angle() const { return solid_angle_; }

  /// Returns barycentric weights, which sum to 1. `part`, 0..solid_angle(), is the solid angle on the first
  /// corner's side of the plane through the pivot and the point; xi goes from the pivot, at 0, to the edge.
  Vec3d weights(float part, float xi) const;

  /// Samples a point as multiples of edge1 and edge2, with solid-angle pdf 1 / solid_angle().
  Vec2d sample(const Vec2f& xi) const;

 private:
  Vec3d pivot_, first_, last_;  ///< unit
  Vec3d inverse_lengths_;       ///< in this order
  double pivot_first_sum_ = 0;  ///< 1 + the cosine between them: half the square of their sum
  double first_last_sum_ = 0;
  /// The triple product of the unit vectors; divided by `sum_`, the tangent of half the solid angle.
  double volume_ = 0;
  double sum_ = 0;
  float solid_angle_ = 0;
};

/// A parallelogram as two spherical triangles about one corner: a continuous map that sweeps around it.
class SphericalParallelogram {
 public:
  SphericalParallelogram(const Vec3d& corner, const Vec3d& edge1, const Vec3d& edge2);

  float solid_angle() const { return first_.solid_angle() + second_.solid_angle(); }

  /// Samples a point as multiples of edge1 and edge2, with solid-angle pdf 1 / solid_angle().
  Vec2d sample(const Vec2f& xi) const;

 private:
  SphericalParallelogram(const Vec3d& corner, const Vec3d& edge1, const Vec3d& edge2, double volume);

  SphericalTriangle first_;
  SphericalTriangle second_;
};

}  // namespace transport
