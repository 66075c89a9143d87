// The light of a clear or hazy sky and of the sun.
#pragma once

#include "grf/math.h"

namespace sky {

/// The turbidity of the air for which the model was fitted, from clear to hazy.
constexpr double LeastTurbidity = 2;
constexpr double LargestTurbidity = 6;

/// The daylight model of Preetham, Shirley and Smits (1999), "A Practical Analytic Model for Daylight", for a
/// sun over the horizon. Colours are CIE XYZ; Y is a luminance in kcd/m2 or an illuminance in klux.
class Daylight {
 public:
  /// The elevation of the sun is in degrees, over 0.
  Daylight(double sun_elevation, double turbidity);

  /// The light of the sky from a direction at an angle from the zenith, of less than a right angle, and one
  /// from the sun, in radians.
  grf::Vec3d sky(double zenith_angle, double sun_angle) const;
  /// The light of the sky at the zenith.
  grf::Vec3d zenith() const;

  /// The irradiance by the sun of a surface that faces it. Its light above the air is that of a black body of
  /// 5778 K with 127.5 klux (IES RP-21). The paper's transmittances by molecules and by aerosols reduce it;
  /// those by ozone, water vapour and mixed gases, some per cent of the light, are left out.
  grf::Vec3d sun() const;

 private:
  /// A distribution over the sky (Perez, Seals and Michalsky 1993) with its value at the zenith.
  struct Distribution {
    double a, b, c, d, e;
    double zenith;
    double value(double zenith_angle, double sun_angle) const;
  };

  double sun_zenith_angle_;  ///< radians
  double turbidity_;
  Distribution luminance_, x_, y_;
};

}  // namespace sky
