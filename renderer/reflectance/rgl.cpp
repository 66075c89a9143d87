#include "renderer/reflectance/rgl.h"

#include <cmath>

namespace reflectance {
namespace {

/// The probability of cosine sampling, so that light that interpolated tables nearly miss never has large
/// weights.
constexpr float CosineProbability = 0.1F;

}  // namespace

Reflection Rgl::reflect(const Vec3f& u, const Vec3f& v) const {
  if (!data || u.z <= 0 || v.z <= 0) return {Rgb(0), 0};
  Reflection reflection = data->reflect(Imath::V3d(u), Imath::V3d(v));
  reflection.pdf = CosineProbability * cosine_pdf(v) + (1 - CosineProbability) * reflection.pdf;
  return reflection;
}

std::optional<DirectionSample> Rgl::sample(const Vec3f& u, const Uniforms& xi) const {
  if (!data || u.z <= 0) return std::nullopt;
  const Vec3f v = xi.choice < CosineProbability
                      ? cosine_direction(xi.direction)
                      : Vec3f(data->direction(Imath::V3d(u), Imath::V2d(xi.direction)));
  if (!(v.z > 0)) return std::nullopt;
  const Reflection reflection = reflect(u, v);
  if (!(reflection.pdf > 0) || !std::isfinite(reflection.pdf)) return std::nullopt;
  return DirectionSample{v, reflection.value * (v.z / reflection.pdf), reflection.pdf};
}

}  // namespace reflectance
