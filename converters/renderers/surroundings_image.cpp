#include "converters/renderers/surroundings_image.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/parallel/loops.h"

namespace convert {
namespace {

constexpr double Pi = std::numbers::pi;
/// Fills an image with the mean of a function over each texel, by points at a regular grid in it.
template <class Radiance>
image::Image filled(int width, int height, int points_across, const Radiance& radiance) {
  image::Image image{width, height, {}};
  image.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  parallel::for_each_index(image.pixels.size(), [&](std::size_t i) {
    const auto row = static_cast<double>(i / static_cast<std::size_t>(width));
    const auto column = static_cast<double>(i % static_cast<std::size_t>(width));
    grf::Vec3d sum(0);
    for (int k = 0; k < points_across * points_across; ++k) {
      const double right = (k % points_across + 0.5) / points_across;
      const double down = (k / points_across + 0.5) / points_across;
      sum += grf::Vec3d(radiance(column + right, row + down));
    }
    image.pixels[i] = grf::Colour(sum / (points_across * points_across));
  });
  return image;
}

}  // namespace

grf::Colour radiance_from(const Surroundings& surroundings, const grf::Vec3d& direction) {
  const image::Image& image = surroundings.image;
  const grf::Vec3d d = direction.normalized();
  const double turns = std::atan2(d.x, -d.z) / (2 * Pi) + double(surroundings.rotation) / 360 + 0.5;
  const double across = turns - std::floor(turns);
  const double down = std::acos(std::clamp(d.y, -1.0, 1.0)) / Pi;
  const auto texel = [](double place, int count) {
    return std::clamp(static_cast<int>(place * count), 0, count - 1);
  };
  return image.at(texel(across, image.width), texel(down, image.height));
}

grf::Vec3d equal_area_direction(const grf::Vec2d& point) {
  const double u = 2 * point.x - 1;
  const double v = 2 * point.y - 1;
  const double height = 1 - std::abs(u) - std::abs(v);
  const double radius = 1 - std::abs(height);
  const double quarter = radius > 0 ? (std::abs(v) - std::abs(u)) / radius + 1 : 1;
  const double phi = quarter * Pi / 4;
  const double from_axis = radius * std::sqrt(2 - radius * radius);
  return {std::copysign(std::cos(phi) * from_axis, u), std::copysign(std::sin(phi) * from_axis, v),
          std::copysign(1 - radius * radius, height)};
}

image::Image equal_area_image(const Surroundings& surroundings) {
  // Twice as fine as the texels at the horizon of the original, of solid angle 2 pi^2/(width height).
  const double texels = double(surroundings.image.width) * double(surroundings.image.height);
  const int size = std::clamp(static_cast<int>(std::ceil(2 * std::sqrt(texels * 2 / Pi))), 16, 4096);
  return filled(size, size, 6, [&](double x, double y) {
    return radiance_from(surroundings, equal_area_direction(grf::Vec2d(x, y) / size));
  });
}

// Mitsuba interpolates between texels, and the original is constant over each: texels of a finer image are
// blurred less.
image::Image mitsuba_latitude_longitude(const Surroundings& surroundings) {
  constexpr int Widest = 4096;
  const image::Image& original = surroundings.image;
  const int finer = std::clamp(Widest / std::max(1, original.width), 1, 4);
  const int width = std::max(4, finer * original.width);
  const int height = std::max(4, finer * original.height + 1);
  return filled(width, height, 2, [&](double x, double y) {
    const double phi = 2 * Pi * x / width;
    const double theta = std::clamp(Pi * (y - 0.5) / (height - 1), 0.0, Pi);
    return radiance_from(
        surroundings, {std::sin(phi) * std::sin(theta), std::cos(theta), -std::cos(phi) * std::sin(theta)});
  });
}

}  // namespace convert
