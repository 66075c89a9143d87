#pragma once

#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// Cosine-weighted directions: what the thesis calls uniform sampling. Covers every BRDF.
struct DiffuseScheme {
  static ModelTable<DiffuseScheme> table() { return {"diffuse", "Cosine-weighted", "", {}}; }

  static std::string refusal(const Brdf&) { return {}; }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    const Vec3f v = cosine_direction(xi.direction);
    if (u.z <= 0 || v.z <= 0 || !has_density(brdf)) return std::nullopt;
    return DirectionSample{v, evaluate(brdf, u, v) * Pi, cosine_density(v)};
  }
  float density(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const {
    return u.z > 0 && has_density(brdf) ? cosine_density(v) : 0;
  }
};

}  // namespace reflectance
