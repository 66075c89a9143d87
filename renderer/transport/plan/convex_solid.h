#pragma once

#include <span>

#include "grf/math.h"

namespace transport {

/// A triangle of a plan, with its plane.
struct PlaneTriangle {
  std::span<const grf::Vec3d> corners;  ///< three, counter-clockwise seen from the front
  grf::Vec3d normal;                    ///< unit
  double height = 0;                    ///< of the plane, along the normal
};

/// True if triangles enclose a convex solid, their fronts outwards: none has a corner in front of another by
/// more than `least`, and each edge is there once in each direction, of corners at the same place.
bool enclose_convex_solid(std::span<const PlaneTriangle> triangles, double least);

}  // namespace transport
