#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace reflectance {

/// The fraction of the lobe (v.r)^n about a mirror direction r that is above the horizon, 1/2 to 1, within
/// 1e-5. It is tabulated over the angle of r to the horizon.
///
/// It is Arvo's single-axis moment (1995) times (n+1)/(2 pi), for real n too. With v at angle psi in the
/// plane of r and the normal, and at angle beta to that plane, v.r is cos(beta) cos(psi), and the lobe's
/// integral is a product of two, of which the horizon clips only the one over psi: of the integral of
/// cos(psi)^n, the part above the horizon stays. That is (1 + I_x(1/2, (n+1)/2)) / 2 with x the squared
/// cosine and I the regularised incomplete beta function, which takes microseconds to evaluate.
class LobeOverHorizon {
 public:
  explicit LobeOverHorizon(double n);

  /// Returns the fraction for the cosine of r to the normal.
  float fraction(float cosine) const {
    const float place = std::asin(std::clamp(cosine, 0.0F, 1.0F)) * steps_per_radian_;
    if (!(place < Steps)) return 1;
    const int step = static_cast<int>(place);
    const float before = shares_[step];
    return before + (place - static_cast<float>(step)) * (shares_[step + 1] - before);
  }

 private:
  static constexpr int Steps = 1024;

  float steps_per_radian_;
  std::array<float, Steps + 1> shares_;
};

}  // namespace reflectance
