#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "renderer/plot/brdf_charts.h"

namespace plot {

/// A BRDF over the hemisphere for one view direction, as a surface whose distance from the centre is the
/// value.
struct LobeMesh {
  double peak = 0;      ///< the largest value in 1/sr
  double specular = 0;  ///< weight of the specular (Dirac) part
  std::vector<reflectance::Vec3f> directions;
  std::vector<float> values;                  ///< value of each direction, in 1/sr
  std::vector<reflectance::Vec3f> positions;  ///< direction times value over peak
  std::vector<reflectance::Vec3f> normals;
  std::vector<std::uint32_t> triangles;
};

/// The numbers of rings about the specular direction, and of sectors around it. Vertices are stored ring by
/// ring, the first one at the specular direction and the last one at the horizon.
struct LobeGrid {
  int rings = 72;
  int sectors = 128;
};

/// Returns the radius of a value relative to the peak; a logarithmic one covers five decades.
double lobe_radius(double value, double peak, bool is_logarithmic);

/// Builds the surface for the view direction u, with directions concentrated about the specular direction.
/// Empty if it was stopped.
LobeMesh lobe_mesh(const reflectance::Brdf& brdf, const reflectance::Vec3f& u, const LobeStyle& style,
                   const LobeGrid& grid = {}, const std::function<bool()>& is_stopped = {});

}  // namespace plot
