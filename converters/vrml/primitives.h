// The solids that VRML has nodes for, as polygons (ISO/IEC 14772-1, chapter 6; VRML 1.0 has the same). All
// are about the origin, along the y axis, with texture coordinates. The material of a face is the number of
// its part, in the order in which VRML 1.0 binds materials to parts.
#pragma once

#include "converters/vrml/polygons.h"

namespace convert::vrml {

/// Around a curved solid.
inline constexpr unsigned SidesOfRound = 32;

/// Parts: front, back, left, right, top, bottom.
Polygons make_box(const grf::Vec3d& size);

Polygons make_sphere(double radius);

struct Ends {
  bool side = true;
  bool top = true;
  bool bottom = true;
};

/// Parts: side, bottom. There is no top.
Polygons make_cone(double bottom_radius, double height, const Ends& ends);

/// Parts: side, top, bottom.
Polygons make_cylinder(double radius, double height, const Ends& ends);

}  // namespace convert::vrml
