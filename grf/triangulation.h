#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "grf/math.h"

namespace grf {

/// Triangulates a polygon: cuts it into corners.size() - 2 triangles that cover it, and appends them as
/// positions in `corners`, in O(n log n). The polygon may be concave, nearly planar, and touch itself, as one
/// with holes does that were cut open along bridges; it is seen in the plane of its own normal. Convex
/// polygons, those without any area, and those that cross themselves so that nothing covers less, are cut as
/// a fan.
void triangulate(std::span<const Vec3f> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace grf
