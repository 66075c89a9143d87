// Polygons that are hard to triangulate, in the plane z = 0, counter-clockwise.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grf/math.h"

namespace shapes {

using Polygon = std::vector<grf::Vec3f>;

/// A polygon with a name for messages, and its area by a closed form.
struct Shape {
  std::string name;
  Polygon polygon;
  double area = 0;
};

/// Shapes of about so many corners: star, comb, zigzag, spiral, needles, plates with holes that were cut open
/// along bridges, slits, corners on straight edges, and repeated ones.
std::vector<Shape> hard_shapes(std::uint32_t corners);

/// Unit squares that hang together by some of their sides as a tree does, so that where they are neighbours
/// otherwise the polygon touches itself. Straight corners may be left out at random, and the squares sheared
/// by whole numbers, so that coordinates are exact.
Shape tree_of_squares(std::uint32_t squares, std::uint32_t seed);

}  // namespace shapes
