#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "renderer/reflectance/geometry.h"

namespace studies {

/// A degree in radians.
constexpr double Degree = std::numbers::pi / 180;

/// Spherical coordinates of a direction in the local frame, in radians.
struct Angles {
  double theta = 0;  ///< from the normal
  double phi = 0;    ///< from the x axis
};

/// Returns the direction at two angles. It is computed in double, so that one at the horizon is exactly
/// there.
inline reflectance::Vec3f direction_of(const Angles& angles) {
  const double sine = std::sin(angles.theta);
  return {static_cast<float>(sine * std::cos(angles.phi)), static_cast<float>(sine * std::sin(angles.phi)),
          static_cast<float>(std::cos(angles.theta))};
}

/// Returns an angle in degrees with four digits, such as "−40°".
std::string degrees_text(double degrees);

/// Returns the words "viewed at θ = 40°, φ = 180°", with φ within half a turn.
std::string viewed_text(const Angles& view);

}  // namespace studies
