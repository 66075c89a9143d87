// Triangulation of polygons of the plane by a sweep line.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <ImathVec.h>

namespace grf {

/// Gives twice the signed area of a triangle, positive if it turns counter-clockwise. Its sign is right, also
/// of triangles with next to no area, wherever the differences of coordinates are exact, as those of floats
/// are unless they differ by more than 2^29 in size.
double orientation(const Imath::V2d& a, const Imath::V2d& b, const Imath::V2d& c);

/// Triangulates a simple polygon, counter-clockwise, in O(n log n), and appends n - 2 triangles of none of
/// which the corners turn clockwise. The polygon may touch itself, as one with holes does that were cut open
/// along bridges. Returns false, with some triangles appended, if the polygon crosses itself so that none
/// were found; of others that cross themselves the triangles may overlap.
///
/// Hertel and Mehlhorn, Fast triangulation of simple polygons, FCT 1983: the sweep meets corners from left to
/// right, and keeps between each two edges where the inside is the chain of corners on the border of what was
/// not cut yet. The corner met is joined to those of the chain that it sees.
bool triangulate_by_sweep(std::span<const Imath::V2d> points,
                          std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace grf
