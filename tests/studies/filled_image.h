#pragma once

#include <cstddef>
#include <vector>

#include "renderer/transport/image/image.h"

namespace test {

/// An image of one colour.
inline transport::Image filled(int width, int height, const reflectance::Rgb& radiance) {
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {width, height, std::vector<reflectance::Rgb>(count, radiance)};
}

}  // namespace test
