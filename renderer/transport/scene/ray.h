#pragma once

#include <algorithm>
#include <cmath>

#include "grf/math.h"
#include "renderer/transport/scene/geometry.h"

namespace transport {

/// What a ray stands for, as a cone about it (Akenine-Moeller, Nilsson, Andersson, Barre-Brisebois, Toth and
/// Karras 2019, "Texture level of detail strategies for real-time ray tracing"). Only textures look at it.
struct RayCone {
  float width = 0;   ///< where the ray starts
  float spread = 0;  ///< growth of the width with distance

  RayCone at(float distance) const { return {width + spread * distance, spread}; }
  /// After a direction was drawn with this density per solid angle: it stands for the more directions the
  /// rarer it is. A sixteenth of 1/density, since other samples share them.
  RayCone widened(float density) const { return {width, std::max(spread, 0.25F / std::sqrt(density))}; }
};

struct Ray {
  Vec3f origin;
  Vec3f direction;  ///< need not be of unit length: distances along the ray count in its lengths
  /// The triangle that the ray leaves and therefore, as it is plane, does not meet.
  TriangleId from = {};
  RayCone cone = {};
};

}  // namespace transport
