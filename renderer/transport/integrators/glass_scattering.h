// Paths meet glass: integrators share what it reflects, refracts and absorbs.
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

/// The solid that a path is in, and the pane that it has met.
struct GlassState {
  const reflectance::Glass* inside = nullptr;  ///< null: it is in none
  Rgb pane_weight = Rgb(1);                    ///< of the reflection by the pane
};

/// A choice between reflection and transmission, and its weight in an estimate.
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

/// Chooses whether a path passes a pane that its ray has met, and if so, moves the ray behind it and returns
/// the factor of its throughput: the pane is none of its hits, so that light sampling and BRDF sampling
/// through it agree on the path's length and pdf. The random word is that of all panes on the ray, and of the
/// opacity of faces: a hash of the triangle makes the choices independent.
inline std::optional<Rgb> pass_pane(const reflectance::Glass& glass, const SurfacePoint& point, bool reflects,
                                    std::uint32_t word, Ray& ray, GlassState& state) {
  constexpr std::uint32_t ApartFromOpacity = 0x70616e65U;
  const float cosine = std::abs(ray.direction.dot(point.geometric_normal));
  const std::uint32_t bits = hash(hash(hash(word, ApartFromOpacity), point.id.instance), point.id.triangle);
  const auto drawn =
      sample_glass(glass.split(cosine, false), reflects, static_cast<float>(bits >> 8U) * 0x1p-24F);
  state.pane_weight = drawn ? drawn->weight : Rgb(0);
  if (!drawn || !drawn->passes) return std::nullopt;
  ray = {point.origin_towards(ray.direction), ray.direction, point.id, point.cone};
  return drawn->weight * point.colour;
}

/// The continuation of a path at glass.
struct GlassStep {
  Rgb weight;                      ///< without the colour of the surface
  std::optional<Ray> passed = {};  ///< the refracted ray; empty: the path is reflected
};

/// Continues a path whose ray had this direction, and notes the solid that it is in then. A pane only
/// reflects here, see `pass_pane`. Radiance grows with the squared index where light enters. Empty if nothing
/// goes on, or if interpolated normals bend the ray to the wrong side.
inline std::optional<GlassStep> step_at_glass(const ShadingPoint& shading, const Vec3f& direction,
                                              bool reflects, float xi, GlassState& state) {
  const SurfacePoint& point = shading.point;
  if (point.surface->is_pane) return GlassStep{state.pane_weight};
  const reflectance::Glass& glass = glass_of(shading.reflector);
  const bool is_inside = direction.dot(point.geometric_normal) > 0;
  const reflectance::Glass::Split split = glass.split(shading.u.z, is_inside);
  const auto drawn = sample_glass(split, reflects, xi);
  if (!drawn || !drawn->passes) return drawn ? std::optional(GlassStep{drawn->weight}) : std::nullopt;
  const float ratio = is_inside ? glass.ior : 1 / glass.ior;
  const Vec3f local(-shading.u.x * ratio, -shading.u.y * ratio, -split.refracted_cosine);
  const Vec3f refracted = shading.frame.to_world(local.normalized());
  if (!(refracted.dot(shading.geometric_normal) < 0)) return std::nullopt;
  state.inside = is_inside ? nullptr : &glass;
  return GlassStep{drawn->weight * (ratio * ratio),
                   Ray{point.origin_towards(refracted), refracted, point.id, point.cone}};
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
/// Returns the same after the way to the point that a ray has met; empty: it has met none.
inline Rgb left_on_way(const reflectance::Glass* inside, const Ray& ray,
                       const std::optional<SurfacePoint>& point) {
  return point ? left_after(inside, (point->position - ray.origin).length()) : left_outside(inside);
}

}  // namespace transport
