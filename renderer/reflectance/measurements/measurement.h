// Measurements are values of a BRDF for pairs of directions, as files list them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/reflectance/geometry.h"

namespace reflectance {

/// The value of a BRDF for one pair of directions.
struct Measurement {
  Imath::V3d u, v;         ///< unit vectors in the local frame, towards the eye and the light
  Imath::V3d value;        ///< f in 1/sr, linear RGB
  double weight = 1;       ///< factor of the squared residual of a fit, and of the share in an interpolation
  double deviation = 0;    ///< standard deviation of the value in 1/sr; 0: unknown
  std::uint32_t line = 0;  ///< of the file that it is from; 0: none
};

/// Returns the direction at an angle from the normal, in radians, and an azimuth. A negative angle is on the
/// other side of the normal.
Imath::V3d direction_at(double theta, double phi);

/// Returns whether all views or all lights have the same azimuth, but for those along the normal: then
/// nothing tells an anisotropic BRDF from an isotropic one.
bool are_isotropic(const std::vector<Measurement>& list);

/// Leaves out what is not finite (1e15 or more), negative, or of directions at or below the horizon, with a
/// warning that counts them and points to the first one's line in `path`.
void remove_faulty(std::vector<Measurement>& list, const std::string& path, grf::Diagnostics& diagnostics);

/// Returns a line of a file, or the file as a whole for line 0; nowhere if there is no file.
grf::SourceLocation line_of(const std::string& path, std::uint32_t line);

}  // namespace reflectance
