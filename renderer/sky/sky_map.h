// Environment maps of a sky with its sun, by place and time.
#pragma once

#include <string>

#include "renderer/image/image.h"
#include "renderer/sky/sun_position.h"

namespace sky {

/// What a map is made of.
struct SkySettings {
  PlaceAndTime at;
  double turbidity = 3;
  /// Direction of north in the scene: degrees from -z, counter-clockwise seen from above. East is 90 degrees
  /// clockwise of it, so of 0 it is +x.
  double north = 0;
  int width = 1024;  ///< texels; the height is half of it
};

/// The diffuse reflectance of the grey ground below the horizon.
constexpr double GroundReflectance = 0.2;
/// The sun's diameter, in degrees, whose light is spread over the texels that it covers.
constexpr double SunDiameter = 0.533;

/// A latitude-longitude map, and what it shows.
struct SkyMap {
  image::Image image;  ///< linear sRGB, whose luminance is in kcd/m2
  SunPosition sun;
  double sky_illuminance = 0;  ///< of a horizontal surface, klux
  double sun_illuminance = 0;  ///< likewise

  /// The brightness (BPT_EM_Scale) that gives a white horizontal surface the radiance 1, to two digits.
  double brightness() const;
};

/// Returns why there is no map of these settings, such as that the sun is below the horizon; empty: there is
/// one.
std::string problem_of(const SkySettings& settings);

/// Makes the map of settings without a problem.
SkyMap sky_map(const SkySettings& settings);

}  // namespace sky
