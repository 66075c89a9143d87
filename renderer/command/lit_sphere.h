#pragma once

#include "renderer/reflectance/reflector.h"
#include "renderer/transport/image/image.h"

namespace command {

/// A sphere of one BRDF on white, seen from afar under a bright window at the upper left and a dim sky:
/// direct light alone, in which highlights saturate softly. Its
/// tangents go around the vertical axis.
transport::Image lit_sphere(const reflectance::Reflector& reflector, int side);

}  // namespace command
