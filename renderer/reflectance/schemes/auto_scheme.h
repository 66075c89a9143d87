#pragma once

#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// The BRDF's own closed-form sampler.
struct AutoScheme {
  static ModelTable<AutoScheme> table() { return {"auto", "The BRDF's own sampler", "", {}}; }

  static std::string refusal(const Brdf&) { return {}; }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    return std::visit([&](const auto& model) { return model.sample(u, xi); }, brdf);
  }
  float density(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const {
    return std::visit([&](const auto& model) { return model.density(u, v); }, brdf);
  }
};

}  // namespace reflectance
