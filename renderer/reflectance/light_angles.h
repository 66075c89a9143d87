#pragma once

#include <vector>

namespace reflectance {

/// Returns the angles in the plane of incidence, in degrees, at which to sample a lobe for a plot. They are
/// denser towards the mirror direction and the view's own, where a narrow lobe peaks.
std::vector<double> light_angles(double view_degrees);

}  // namespace reflectance
