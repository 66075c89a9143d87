#pragma once

#include <string>

#include "renderer/plot/svg.h"
#include "renderer/reflectance/reflector.h"

namespace command {

/// A BRDF in four views: polar and cartesian in the plane of incidence for several view angles, its albedo
/// over the view angle, and a sphere of it under a bright window.
plot::Svg picture_of(const reflectance::Reflector& reflector, const std::string& title);

}  // namespace command
