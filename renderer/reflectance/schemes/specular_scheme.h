#pragma once

#include "renderer/reflectance/schemes/diffuse_scheme.h"

namespace reflectance {

/// The mirror direction. A BRDF's Dirac part is always drawn by its own probability (see Reflector), so what
/// is left for this scheme is the rest, where a BRDF has one: that is drawn by cosine, or it would be lost.
struct SpecularScheme {
  static ModelTable<SpecularScheme> table() {
    return {.keyword = "specular",
            .title = "Mirror direction",
            .about =
                "The mirror direction of the view, for BRDFs that reflect a share of the light into that "
                "direction alone. What else they reflect is drawn by cosine."};
  }

  static std::string refusal(const Brdf& brdf) {
    return has_mirror(brdf) ? ""
                            : "it reflects nothing into the mirror direction alone: use 'diffuse' or 'auto'";
  }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    return DiffuseScheme().sample(brdf, u, xi);
  }
  float density(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const {
    return DiffuseScheme().density(brdf, u, v);
  }
};

}  // namespace reflectance
