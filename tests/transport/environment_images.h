// Environment images for tests.
#pragma once

#include <cmath>
#include <numbers>

#include "renderer/image/image.h"

namespace test {

/// Makes a grey image whose texels are given by a function of their position.
template <class Function>
image::Image image_of(int width, int height, Function texel) {
  image::Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.pixels.push_back(grf::Colour(texel(x, y)));
  }
  return image;
}

/// Returns the direction to (x, y) of a map, in texels from the upper left corner, by the definition: y is
/// up, and the centre looks down -z.
template <class Real>
Imath::Vec3<Real> direction_at(const image::Image& image, Real x, Real y) {
  const Real theta = std::numbers::pi_v<Real> * y / static_cast<Real>(image.height);
  const Real phi = 2 * std::numbers::pi_v<Real> * (x / static_cast<Real>(image.width) - Real(0.5));
  return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

}  // namespace test
