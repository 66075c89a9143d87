#include "renderer/studies/angles.h"

#include <fmt/format.h>

namespace studies {

std::string degrees_text(double degrees) {
  return fmt::format("{}{:.4g}\u00B0", degrees < 0 ? "\u2212" : "", std::abs(degrees));
}

std::string viewed_text(const Angles& view) {
  constexpr double AlmostHalfATurn = 179.95;  // which four digits do not tell from it
  double phi = std::remainder(view.phi / Degree, 360.0);
  if (phi < -AlmostHalfATurn) phi = 180;
  return fmt::format("viewed at \u03B8 = {}, \u03C6 = {}", degrees_text(view.theta / Degree),
                     degrees_text(phi));
}

}  // namespace studies
