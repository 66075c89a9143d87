#pragma once

#include <vector>

namespace reflectance {

/// Where a lobe is looked at in the plane of incidence, in degrees: everywhere, and closer and closer to the
/// mirror direction and to the view's own, where a narrow lobe has its peak.
std::vector<double> light_angles(double view_degrees);

}  // namespace reflectance
