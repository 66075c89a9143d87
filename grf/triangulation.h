#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "grf/math.h"

namespace grf {

/// Cuts a polygon into corners.size() - 2 triangles that cover it, and appends them as positions in
/// `corners`. Works for polygons that are concave or nearly planar, by clipping ears in the plane of the
/// polygon's own normal; one without any area, or that crosses itself, is cut as a fan.
void triangulate(std::span<const Vec3f> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace grf
