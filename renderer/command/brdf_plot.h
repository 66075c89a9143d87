#pragma once

#include <string>

#include "renderer/plot/svg.h"
#include "renderer/reflectance/reflector.h"

namespace command {

/// Plots a BRDF in four panels: polar and cartesian in the plane of incidence for several view angles, albedo
/// over the view angle, and a sphere lit by a bright window.
plot::Svg picture_of(const reflectance::Reflector& reflector, const std::string& title);

}  // namespace command
