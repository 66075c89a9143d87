#pragma once

#include <cstdint>
#include <vector>

#include "editor/brdf/lobe_curves.h"

namespace editor {

/// A BRDF over the hemisphere for one view direction, as a surface whose distance from the centre is the
/// value.
struct LobeMesh {
  double view = 0;      ///< degrees from the normal, on the side of negative x
  double peak = 0;      ///< the largest value in 1/sr
  double specular = 0;  ///< weight of the specular (Dirac) part
  std::vector<reflectance::Vec3f> directions;
  std::vector<float> values;                  ///< value of each direction, in 1/sr
  std::vector<reflectance::Vec3f> positions;  ///< direction times value over peak
  std::vector<reflectance::Vec3f> normals;
  std::vector<std::uint32_t> triangles;
};

/// Builds the surface from f or f times the light's cosine, in luminance, with directions concentrated about
/// the specular direction. A logarithmic radius covers five decades. Empty if the flag was set.
LobeMesh lobe_mesh(const reflectance::Brdf& brdf, double view, bool with_cosine, bool is_logarithmic,
                   const StopFlag& stop);

}  // namespace editor
