#pragma once

#include <span>
#include <string_view>

#include "converters/vrml/node.h"
#include "grf/math.h"

namespace convert::vrml {

/// A turn about an axis: its three components and the angle in radians, counter-clockwise seen from the axis'
/// end. About no axis, nothing turns; no numbers are no turn.
grf::Matrix44d rotation_of(std::span<const double> axis_and_angle);

/// The transform of a Transform node of either version (ISO/IEC 14772-1, 6.52), which names its scale
/// differently.
grf::Matrix44d matrix_of_transform(const NodeReader& node, std::string_view scale_field);

}  // namespace convert::vrml
