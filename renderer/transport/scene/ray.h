#pragma once

#include <algorithm>
#include <cmath>

#include "grf/math.h"
#include "renderer/transport/scene/geometry.h"

namespace transport {

/// The footprint of a ray, as a cone about it (Akenine-Moeller, Nilsson, Andersson, Barre-Brisebois, Toth and
/// Karras 2019, "Texture level of detail strategies for real-time ray tracing"). Used only for textures.
struct RayCone {
  float width = 0;   ///< at the ray's origin
  float spread = 0;  ///< growth of the width with distance

  RayCone at(float distance) const { return {width + spread * distance, spread}; }
  /// Widens the cone after a direction was sampled with this solid-angle pdf: the lower it is, the more
  /// directions the ray stands for. The solid angle is 1/16 of 1/pdf, since other samples share it.
  RayCone widened(float pdf) const { return {width, std::max(spread, 0.25F / std::sqrt(pdf))}; }
};

struct Ray {
  Vec3f origin;
  Vec3f direction;  ///< need not be unit: distances along the ray are multiples of its length
  /// The triangle that the ray leaves, which it cannot hit because it is plane.
  TriangleId from = {};
  RayCone cone = {};
};

}  // namespace transport
