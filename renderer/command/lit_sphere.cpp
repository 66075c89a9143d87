#include "renderer/command/lit_sphere.h"

#include <cmath>
#include <cstdint>

#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/halton.h"

namespace command {
namespace {

using reflectance::Reflector;
using reflectance::Rgb;
using reflectance::Uniforms;
using reflectance::Vec3f;

constexpr int SphereSubpixels = 2;  // along each side of a pixel
constexpr int SamplesPerSubpixel = 24;
constexpr float WindowRadiance = 12;
constexpr float HalfWindow = 0.28F;  // half the side length, at distance 1

/// Returns the direction to the window's centre: up, left and in front. x points right, y up, z to the eye.
const Vec3f& to_window() {
  static const Vec3f direction = Vec3f(-0.55F, 0.65F, 0.6F).normalized();
  return direction;
}

// The window's own axes.
Vec3f across() { return Vec3f(0, 1, 0).cross(to_window()).normalized(); }
Vec3f upwards() { return to_window().cross(across()); }

float pdf_of_window(const Vec3f& direction) {
  const float cosine = direction.dot(to_window());
  if (cosine <= 0) return 0;
  const Vec3f at_window = direction / cosine;
  const bool inside =
      std::abs(at_window.dot(across())) < HalfWindow && std::abs(at_window.dot(upwards())) < HalfWindow;
  return inside ? 1 / (4 * HalfWindow * HalfWindow * cosine * cosine * cosine) : 0;
}

Vec3f direction_to_window(const reflectance::Vec2f& xi) {
  return (to_window() + across() * (HalfWindow * (2 * xi.x - 1)) + upwards() * (HalfWindow * (2 * xi.y - 1)))
      .normalized();
}

Rgb radiance_from(const Vec3f& direction) {
  if (pdf_of_window(direction) > 0) return Rgb(WindowRadiance);
  const float sky = 0.5F + 0.5F * direction.y;
  return Rgb(0.12F, 0.12F, 0.13F) * (1 - sky) + Rgb(0.45F, 0.5F, 0.6F) * sky;
}

/// Hashes a pixel and a dimension to a number in [0,1) (splitmix64).
float hashed(std::uint32_t pixel, std::uint32_t dimension) {
  std::uint64_t x = (std::uint64_t{pixel} << 2U | dimension) * 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
  return static_cast<float>((x ^ (x >> 31U)) >> 40U) * 0x1p-24F;
}

/// Returns a sample of a pixel, decorrelated from its neighbours by a Cranley-Patterson rotation.
Uniforms point_of_pixel(std::uint32_t pixel, std::uint32_t sample) {
  const Uniforms even = reflectance::halton_point(sample);
  const auto shifted = [pixel](float a, std::uint32_t dimension) {
    const float sum = a + hashed(pixel, dimension);
    return sum < 1 ? sum : sum - 1;
  };
  return {{shifted(even.direction.x, 0), shifted(even.direction.y, 1)}, shifted(even.choice, 2)};
}

/// Estimates the reflected radiance of window and sky. The window is sampled by BRDF and by area, combined by
/// multiple importance sampling (balance heuristic).
Rgb reflected(const Reflector& reflector, const reflectance::Frame& frame, const Vec3f& u,
              const Uniforms& xi) {
  Rgb sum(0);
  if (const auto drawn = reflector.sample(u, xi)) {
    const Vec3f direction = frame.to_world(drawn->direction);
    const float window = pdf_of_window(direction);
    const float mis_weight = drawn->is_specular || window == 0 ? 1 : drawn->pdf / (drawn->pdf + window);
    sum += drawn->weight * radiance_from(direction) * mis_weight;
  }
  const Vec3f direction = direction_to_window(xi.direction);
  const Vec3f v = frame.to_local(direction);
  const float pdf = pdf_of_window(direction);
  if (v.z > 0 && pdf > 0) {
    const float weight = v.z / (pdf + reflector.pdf(u, v));
    sum += reflector.evaluate(u, v) * radiance_from(direction) * weight;
  }
  return sum;
}

reflectance::Frame frame_at(const Vec3f& normal) {
  reflectance::Frame frame(normal);
  const Vec3f around = Vec3f(0, 1, 0).cross(normal);
  if (around.length2() > 0) {
    frame.x = around.normalized();
    frame.y = normal.cross(frame.x);
  }
  return frame;
}

/// Tone maps a radiance by an exponential curve: linear where it is dim, saturating where it is bright.
Rgb tone_mapped(const Rgb& radiance) {
  constexpr float Exposure = 1.3F;
  return Rgb(-std::expm1(-Exposure * radiance.x), -std::expm1(-Exposure * radiance.y),
             -std::expm1(-Exposure * radiance.z));
}

/// Renders one of the side x side squares of the image; the background is white.
Rgb subpixel(const Reflector& reflector, int column, int row, int side) {
  const float radius = 0.47F * static_cast<float>(side);
  const float centre = 0.5F * static_cast<float>(side);
  Rgb sum(0);
  float covered = 0;
  for (std::uint32_t k = 0; k < SamplesPerSubpixel; ++k) {
    const Uniforms place = reflectance::halton_point(k + 1);
    const float x = (static_cast<float>(column) + place.direction.x - centre) / radius;
    const float y = (centre - static_cast<float>(row) - place.direction.y) / radius;
    const float z2 = 1 - x * x - y * y;
    if (z2 <= 0) continue;
    const reflectance::Frame frame = frame_at(Vec3f(x, y, std::sqrt(z2)));
    sum += reflected(reflector, frame, frame.to_local(Vec3f(0, 0, 1)),
                     point_of_pixel(static_cast<std::uint32_t>(row * side + column), k));
    covered += 1;
  }
  const float coverage = covered / static_cast<float>(SamplesPerSubpixel);
  return covered > 0 ? tone_mapped(sum / covered) * coverage + Rgb(1 - coverage) : Rgb(1);
}

}  // namespace

image::Image lit_sphere(const Reflector& reflector, int side) {
  image::Image image{side, side, {}};
  const int fine_side = SphereSubpixels * side;
  for (int i = 0; i < side * side; ++i) {
    Rgb sum(0);
    for (int k = 0; k < SphereSubpixels * SphereSubpixels; ++k) {
      const int x = SphereSubpixels * (i % side) + k % SphereSubpixels;
      const int y = SphereSubpixels * (i / side) + k / SphereSubpixels;
      sum += subpixel(reflector, x, y, fine_side);
    }
    image.pixels.push_back(sum / static_cast<float>(SphereSubpixels * SphereSubpixels));
  }
  return image;
}

}  // namespace command
