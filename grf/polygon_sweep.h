// A sweep line triangulates planar polygons.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <ImathVec.h>

namespace grf {

/// Computes twice the signed area of a triangle, positive if it is counter-clockwise. The sign is exact, even
/// for nearly degenerate triangles, wherever the differences of coordinates are exact, as those of floats are
/// unless their magnitudes differ by more than 2^29.
double orientation(const Imath::V2d& a, const Imath::V2d& b, const Imath::V2d& c);

/// Triangulates a simple, counter-clockwise polygon in O(n log n), and appends n - 2 triangles, none of them
/// clockwise. The polygon may touch itself, as one does whose holes were connected by bridge edges. Returns
/// false, with some triangles appended, if a self-intersecting polygon has no triangulation; for other
/// self-intersecting polygons the triangles may overlap.
///
/// Hertel and Mehlhorn, Fast triangulation of simple polygons, FCT 1983: the sweep line meets corners from
/// left to right, and keeps, for each pair of edges with the interior between them, the chain of corners on
/// the border of the region not triangulated yet. Each corner is connected to those of the chain that it
/// sees.
bool triangulate_by_sweep(std::span<const Imath::V2d> points,
                          std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace grf
