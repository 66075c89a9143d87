#include "tests/benchmarks/render/outdoor_map.h"

#include <cmath>
#include <numbers>

namespace benchmark {
namespace {

using grf::Colour;
constexpr double Pi = std::numbers::pi;

Colour radiance_from(const Imath::V3d& direction) {
  const Imath::V3d sun = Imath::V3d(0.45, std::tan(50 * Pi / 180) * 0.75, 0.6).normalized();
  const double cosine = direction.dot(sun);
  if (cosine > std::cos(0.5 * Pi / 180)) return {9000, 8200, 7000};
  if (direction.y < 0) return {0.12F, 0.11F, 0.09F};
  const auto haze = static_cast<float>(std::exp(-4 * direction.y));
  const auto glow = static_cast<float>(std::exp(-40 * (1 - cosine)));
  return Colour(0.18F, 0.32F, 0.65F) + haze * Colour(0.45F, 0.42F, 0.3F) + glow * Colour(3, 2.6F, 2);
}

}  // namespace

image::Image outdoor_map() {
  image::Image image{1024, 512, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double theta = Pi * (y + 0.5) / image.height;
      const double phi = 2 * Pi * ((x + 0.5) / image.width - 0.5);
      image.pixels.push_back(radiance_from(
          {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)}));
    }
  }
  return image;
}

}  // namespace benchmark
