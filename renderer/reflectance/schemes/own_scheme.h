#pragma once

#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// The BRDF's own closed-form sampler.
struct OwnScheme {
  static ModelTable<OwnScheme> table() {
    return {.keyword = "own",
            .title = "The BRDF's own sampler",
            .description =
                "The closed-form importance sampling of each BRDF: exact or nearly so if the model's lobe "
                "can be inverted, else that of a similar lobe combined with cosine-weighted directions. It "
                "has no tables and no parameters."};
  }

  static std::string unsupported_reason(const Brdf&) { return {}; }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    return own_sample(brdf, u, xi);
  }
  float pdf(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const { return own_pdf(brdf, u, v); }
};

}  // namespace reflectance
