#pragma once

#include "renderer/reflectance/schemes/diffuse_scheme.h"

namespace reflectance {

/// The mirror direction. Reflector always picks a BRDF's delta part with its own probability, so this scheme
/// only samples the rest, if any, by the cosine; else it would be lost.
struct SpecularScheme {
  static ModelTable<SpecularScheme> table() {
    return {.keyword = "specular",
            .title = "Mirror direction",
            .description =
                "The mirror direction of the view, for BRDFs with a delta part (ideal mirrors). Anything "
                "else that they reflect is sampled by the cosine."};
  }

  static std::string unsupported_reason(const Brdf& brdf) {
    return has_specular_part(brdf) ? "" : "the BRDF has no mirror (delta part): use 'diffuse' or 'auto'";
  }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    return DiffuseScheme().sample(brdf, u, xi);
  }
  float pdf(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const {
    return DiffuseScheme().pdf(brdf, u, v);
  }
};

}  // namespace reflectance
