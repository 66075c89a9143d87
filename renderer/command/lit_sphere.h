#pragma once

#include "renderer/image/image.h"
#include "renderer/reflectance/reflector.h"

namespace command {

/// Renders a sphere of one BRDF on white by direct light only, in an orthographic view, under a bright window
/// at the upper left and a dim sky. Highlights are tone mapped. Tangents go around the vertical axis.
image::Image lit_sphere(const reflectance::Reflector& reflector, int side);

}  // namespace command
