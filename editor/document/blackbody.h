// A black body's temperature gives the colour of thermal light.
#pragma once

#include <optional>

#include "grf/math.h"

namespace editor {

/// The range of colour temperatures, in kelvin.
inline constexpr double LeastTemperature = 1000;
inline constexpr double LargestTemperature = 40000;

/// Computes the linear sRGB colour of a black body at a temperature in kelvin, with luminance 1: Planck's law
/// integrated with the colour matching functions of the CIE 1931 2-degree observer, in the analytic fit of
/// Wyman, Sloan and Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT
/// 2(2), 2013, table 1. Negative channels, as below 1900 K, are 0.
grf::Vec3d blackbody_colour(double kelvin);

/// Computes the CIE xy chromaticity of a linear sRGB colour that is not black.
grf::Vec2d chromaticity_of(const grf::Vec3d& colour);

/// The colour temperature whose black body has the chromaticity of a colour, in kelvin, rounded to integers;
/// nothing if none has.
std::optional<double> temperature_of(const grf::Colour& colour);

}  // namespace editor
