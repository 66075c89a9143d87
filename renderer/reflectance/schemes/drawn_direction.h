#pragma once

#include "renderer/reflectance/model.h"

namespace reflectance {

/// A sampled direction with its solid-angle pdf.
struct DrawnDirection {
  Vec3f direction;
  float density = 0;
};

}  // namespace reflectance
