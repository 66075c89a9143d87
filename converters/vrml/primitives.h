// VRML's geometric primitives are tessellated as ISO/IEC 14772-1, chapter 6, defines them; VRML 1.0 has the
// same. All are centred at the origin, along the y axis, with texture coordinates. The material of a face is
// the index of its part, in the order in which VRML 1.0 binds materials to parts.
#pragma once

#include "converters/vrml/polygons.h"

namespace convert::vrml {

/// The number of sides around a curved solid.
inline constexpr unsigned SidesOfRound = 32;

/// Makes a box with the parts front, back, left, right, top, bottom.
Polygons make_box(const grf::Vec3d& size);

Polygons make_sphere(double radius);

struct Ends {
  bool side = true;
  bool top = true;
  bool bottom = true;
};

/// Makes a cone with the parts side, bottom; there is no top.
Polygons make_cone(double bottom_radius, double height, const Ends& ends);

/// Makes a cylinder with the parts side, top, bottom.
Polygons make_cylinder(double radius, double height, const Ends& ends);

}  // namespace convert::vrml
