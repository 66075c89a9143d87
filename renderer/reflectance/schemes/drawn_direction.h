#pragma once

#include "renderer/reflectance/model.h"

namespace reflectance {

/// A direction and its density per solid angle.
struct DrawnDirection {
  Vec3f direction;
  float density = 0;
};

}  // namespace reflectance
