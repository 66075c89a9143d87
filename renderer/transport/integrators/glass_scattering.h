// What glass does to a path that meets it.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <variant>

#include "renderer/reflectance/glass.h"
#include "renderer/transport/integrators/shading_point.h"
#include "renderer/transport/sobol.h"

namespace transport {

/// Returns the glass that a surface is; it must be one.
inline const reflectance::Glass& glass_of(const reflectance::Reflector& reflector) {
  return *std::get_if<reflectance::Glass>(&reflector.brdf());
}

/// Whether light goes on after glass, and its weight in an estimate.
struct GlassSample {
  bool passes = false;
  Rgb weight;
};

/// Chooses between reflection and transmission by their energies. Where nothing is to be reflected, the path
/// passes. Empty if nothing goes on.
inline std::optional<GlassSample> sample_glass(const reflectance::Glass::Split& split, bool reflects,
                                               float xi) {
  const float reflected = reflects ? reflectance::mean(split.reflected) : 0;
  const float transmitted = reflectance::mean(split.transmitted);
  if (!(reflected + transmitted > 0)) return std::nullopt;
  const float chance = reflected / (reflected + transmitted);
  if (xi < chance) return GlassSample{false, split.reflected / chance};
  return GlassSample{true, split.transmitted / (1 - chance)};
}

/// The choice at a pane, by a random word of all panes that the ray meets, and of the opacity of faces: a
/// hash of the triangle makes the choices independent. A ray that comes along the pane goes on by reflection.
inline std::optional<GlassSample> sample_pane(const reflectance::Glass& glass, const SurfacePoint& point,
                                              const Vec3f& direction, bool reflects, std::uint32_t word) {
  constexpr std::uint32_t ApartFromOpacity = 0x70616e65U;
  const float cosine = std::abs(direction.dot(point.geometric_normal));
  const std::uint32_t bits = hash(hash(hash(word, ApartFromOpacity), point.id.instance), point.id.triangle);
  return sample_glass(glass.split(cosine, false), reflects, static_cast<float>(bits >> 8U) * 0x1p-24F);
}

/// The ray that goes straight on behind a pane.
inline Ray behind_pane(const SurfacePoint& point, const Ray& ray) {
  return {point.origin_towards(ray.direction), ray.direction, point.id, point.cone};
}

/// The ray that continues in a solid or leaves it, and the factor of radiance, which grows with the squared
/// index where light enters. Empty if interpolated normals bend it to the wrong side.
struct RefractedRay {
  Ray ray;
  float radiance_factor = 1;
};
inline std::optional<RefractedRay> refracted(const ShadingPoint& shading, const reflectance::Glass& glass,
                                             float refracted_cosine, bool is_inside) {
  const float ratio = is_inside ? glass.ior : 1 / glass.ior;
  const Vec3f local(-shading.u.x * ratio, -shading.u.y * ratio, -refracted_cosine);
  const Vec3f direction = shading.frame.to_world(local.normalized());
  const SurfacePoint& point = shading.point;
  if (!(direction.dot(shading.geometric_normal) < 0)) return std::nullopt;
  return RefractedRay{{point.origin_towards(direction), direction, point.id, point.cone}, ratio * ratio};
}

/// Returns what is left of light after a way in a glass that may be none.
inline Rgb left_after(const reflectance::Glass* inside, float way) {
  return inside == nullptr ? Rgb(1) : inside->left_after(way);
}
/// Returns the same after a way without end, such as out of a solid that is not closed.
inline Rgb left_outside(const reflectance::Glass* inside) {
  if (inside == nullptr) return Rgb(1);
  const Rgb& colour = inside->colour;
  return {colour.x < 1 ? 0.0F : 1.0F, colour.y < 1 ? 0.0F : 1.0F, colour.z < 1 ? 0.0F : 1.0F};
}

}  // namespace transport
