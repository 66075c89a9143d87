// An environment map as a few distant lights and a dimmer rest, for shading in real time.
#pragma once

#include <vector>

#include "renderer/image/image.h"
#include "renderer/reflectance/lit_surface.h"

namespace studies {

/// The brightest parts of an environment map, such as the sun, as distant lights in the map's own frame. Few
/// samples of the rest of the map have little noise.
struct MapLights {
  /// The luminance that the rest of the map is limited to. The lights have what exceeds it.
  float limit = 0;
  std::vector<reflectance::DistantLight> lights;
};

/// The greatest number of lights of a map.
constexpr int MostMapLights = 16;

/// Finds the lights of a latitude-longitude map without negative texels. Luminance above 16 times the map's
/// mean is cut into regions of about equal energy, which have a light each at their centroid (median cut:
/// Debevec 2005, "A Median Cut Algorithm for Light Probe Sampling"); regions smaller than 4 degrees are not
/// cut. The irradiance of all lights and the rest of the map together is that of the map.
MapLights map_lights(const image::Image& image, int most_lights = MostMapLights);

/// Returns the part of a radiance that the lights leave to the rest of the map: of the same colour, with a
/// luminance up to the limit.
reflectance::Rgb below_limit(const reflectance::Rgb& radiance, float limit);

/// Returns the image with at most 2048 x 1024 texels, box-filtered by solid angle, and with 0 for channels
/// that are negative or not finite.
image::Image reduced_map(image::Image image);

}  // namespace studies
