#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "renderer/reflectance/measurements/measurement.h"

namespace reflectance {

/// Returns whether the first line of a text, after comments, has the names of a CSV file's columns.
bool sniff_csv(std::string_view text);

/// Reads measurements from the text of a CSV file; returns nothing after an error, which names line and
/// column. The first line names the columns: `theta_u,phi_u,theta_v,phi_v` in radians or
/// `ux,uy,uz,vx,vy,vz`, then `r,g,b` or `value` in 1/sr, and perhaps `weight` or `deviation`; in any order.
/// `theta_o,phi_o` are the angles of the view too, `theta_i,phi_i` those of the light, and `_deg` after the
/// name of an angle says that it is in degrees. Lines that start with `#` are comments.
std::optional<std::vector<Measurement>> parse_csv(std::string_view text, const std::string& path,
                                                  grf::Diagnostics& diagnostics);

}  // namespace reflectance
