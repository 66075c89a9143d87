#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/reflectance/measurements/measurement.h"

namespace reflectance {

/// Returns whether a text has the line `VARS` of ASTM E1392, with an angle after it.
bool sniff_astm(std::string_view text);

/// Reads the measurements of a text after ASTM E1392: lines of keywords up to `VARS`, which names the columns
/// of the lines that follow: `theta_i,phi_i` of the light, `theta_s,phi_s` of the view (or `theta_r,phi_r`),
/// and the values in 1/sr: one column, or `R,G,B`, or `X,Y,Z`, or one per wavelength, such as `550nm`. Angles
/// are in radians, or in degrees if one from the normal is larger than a right angle in radians; a negative
/// one is on the other side of the normal. Returns nothing after an error, which names line and column.
std::optional<std::vector<Measurement>> parse_astm(std::string_view text, const std::string& path,
                                                   grf::Diagnostics& diagnostics);

}  // namespace reflectance
