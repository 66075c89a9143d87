// Polygons that are hard to triangulate are made in the plane z = 0, counter-clockwise.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grf/math.h"

namespace shapes {

using Polygon = std::vector<grf::Vec3f>;

/// A polygon with a name for messages and its area in closed form.
struct Shape {
  std::string name;
  Polygon polygon;
  double area = 0;
};

/// Returns shapes of about so many vertices: star, comb, zigzag, spiral, needles, plates with holes cut open
/// along bridges, slits, collinear vertices, and repeated ones.
std::vector<Shape> hard_shapes(std::uint32_t corners);

/// Returns the outline of unit squares that are connected as a tree, so that the polygon touches itself where
/// other squares are adjacent. Collinear vertices may be left out at random, and the squares sheared by whole
/// numbers, so that coordinates are exact.
Shape tree_of_squares(std::uint32_t squares, std::uint32_t seed);

}  // namespace shapes
