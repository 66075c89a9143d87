#pragma once

#include <span>
#include <string_view>

#include "converters/vrml/node.h"
#include "grf/math.h"

namespace convert::vrml {

/// Computes a rotation about an axis from its three components and the angle in radians, counter-clockwise
/// seen from the tip of the axis. A zero axis or no numbers give the identity.
grf::Matrix44d rotation_of(std::span<const double> axis_and_angle);

/// Computes the matrix of a Transform node of either version (ISO/IEC 14772-1, 6.52); the name of the scale
/// field differs.
grf::Matrix44d matrix_of_transform(const NodeReader& node, std::string_view scale_field);

}  // namespace convert::vrml
