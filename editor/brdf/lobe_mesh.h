#pragma once

#include <cstdint>
#include <vector>

#include "editor/brdf/lobe_curves.h"

namespace editor {

/// A BRDF over the hemisphere for one view, as a surface: its distance from the centre is the value.
struct LobeMesh {
  double view = 0;    ///< degrees from the normal, on the side of negative x
  double peak = 0;    ///< the largest value in 1/sr
  double mirror = 0;  ///< the weight of the Dirac part
  std::vector<reflectance::Vec3f> directions;
  std::vector<float> values;                  ///< of each direction, in 1/sr
  std::vector<reflectance::Vec3f> positions;  ///< direction times value over peak
  std::vector<reflectance::Vec3f> normals;
  std::vector<std::uint32_t> triangles;
};

/// Values are f or f times the light's cosine, in luminance. Directions are closer together about the mirror
/// direction. Logarithmic lengths go over five powers of ten. Empty after the flag is set.
LobeMesh lobe_mesh(const reflectance::Brdf& brdf, double view, bool with_cosine, bool is_logarithmic,
                   const StopFlag& stop);

}  // namespace editor
