#pragma once

#include <cstddef>
#include <vector>

#include "renderer/image/image.h"

namespace test {

/// An image of one colour.
inline image::Image filled(int width, int height, const grf::Colour& radiance) {
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {width, height, std::vector<grf::Colour>(count, radiance)};
}

}  // namespace test
