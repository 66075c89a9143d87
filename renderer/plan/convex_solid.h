#pragma once

#include <span>

#include "grf/math.h"

namespace plan {

/// A triangle of the coarse scene, with its plane.
struct PlaneTriangle {
  std::span<const grf::Vec3d> corners;  ///< three, counter-clockwise seen from the front
  grf::Vec3d normal;                    ///< unit
  double height = 0;                    ///< distance of the plane from the origin, along the normal
};

/// Whether triangles enclose a convex solid, with their fronts outwards: no corner is in front of another
/// triangle by more than `least`, and each edge occurs once in each direction, between corners at the same
/// positions.
bool enclose_convex_solid(std::span<const PlaneTriangle> triangles, double least);

}  // namespace plan
