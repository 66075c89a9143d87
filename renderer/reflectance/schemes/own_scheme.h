#pragma once

#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// The BRDF's own closed-form sampler.
struct OwnScheme {
  static ModelTable<OwnScheme> table() {
    return {.keyword = "own",
            .title = "The BRDF's own sampler",
            .about =
                "Each BRDF has a sampler in closed form that was written "
                "for it: exact or nearly so where the model's lobe can be inverted, and else that of a like "
                "lobe together with a matte part. It has no tables and nothing to set."};
  }

  static std::string refusal(const Brdf&) { return {}; }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    return own_sample(brdf, u, xi);
  }
  float density(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const { return own_density(brdf, u, v); }
};

}  // namespace reflectance
