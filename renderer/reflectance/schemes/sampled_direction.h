#pragma once

#include "renderer/reflectance/model.h"

namespace reflectance {

/// A sampled direction with its solid-angle pdf.
struct SampledDirection {
  Vec3f direction;
  float pdf = 0;
};

}  // namespace reflectance
