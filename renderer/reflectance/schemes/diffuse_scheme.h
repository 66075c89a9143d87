#pragma once

#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// Cosine-weighted sampling, which the thesis calls uniform sampling. Supports every BRDF.
struct DiffuseScheme {
  static ModelTable<DiffuseScheme> table() {
    return {.keyword = "diffuse",
            .title = "Cosine-weighted",
            .description =
                "Cosine-weighted hemisphere sampling, as for a diffuse surface; the thesis calls it uniform, "
                "which it is on the unit disc. It is perfect for Lambert's model, safe for every other, and "
                "the noisier the glossier the BRDF: the baseline for the other schemes."};
  }

  static std::string unsupported_reason(const Brdf&) { return {}; }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    const Vec3f v = cosine_direction(xi.direction);
    if (u.z <= 0 || v.z <= 0 || !has_nonspecular_part(brdf)) return std::nullopt;
    return DirectionSample{v, evaluate(brdf, u, v) * Pi, cosine_pdf(v)};
  }
  float pdf(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const {
    return u.z > 0 && has_nonspecular_part(brdf) ? cosine_pdf(v) : 0;
  }
};

}  // namespace reflectance
