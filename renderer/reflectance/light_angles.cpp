#include "renderer/reflectance/light_angles.h"

#include <algorithm>

namespace reflectance {

std::vector<double> light_angles(double view_degrees) {
  constexpr int StepsOfADegree = 10;
  constexpr int ClosestSteps = 18;  // down to about 1e-4 degrees
  std::vector<double> angles;
  for (int i = 0; i < 180 * StepsOfADegree; ++i) angles.push_back((i + 0.5) / StepsOfADegree - 90);
  for (const double peak : {view_degrees, -view_degrees}) {
    angles.push_back(peak);
    double distance = 1.0 / StepsOfADegree;
    for (int i = 0; i < ClosestSteps; ++i) {
      angles.push_back(peak - distance);
      angles.push_back(peak + distance);
      distance /= 1.5;
    }
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

}  // namespace reflectance
