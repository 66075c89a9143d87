#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "grf/math.h"

namespace grf {

/// Triangulates a polygon into corners.size() - 2 triangles that cover it, and appends them as indices into
/// `corners`, in O(n log n). The polygon may be concave, nearly planar, and touch itself, as one does whose
/// holes were connected by bridge edges; it is projected along its own normal. Convex and degenerate polygons
/// become a triangle fan, and so do self-intersecting ones of which no triangulation covers less area.
void triangulate(std::span<const Vec3f> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace grf
