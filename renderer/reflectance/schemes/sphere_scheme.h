#pragma once

#include "renderer/reflectance/cosine_lobe.h"
#include "renderer/reflectance/schemes/lobe_exponent.h"
#include "renderer/reflectance/schemes/weighted.h"

namespace reflectance {

/// Samples a cosine lobe about the mirror direction, on the whole sphere. Directions below the horizon are
/// drawn and count as zero, so the pdf integrates to less than 1 over the hemisphere.
struct SphereScheme {
  static constexpr bool IsIncomplete = true;

  float exponent = OwnExponent;

  static ModelTable<SphereScheme> table() {
    return {
        .keyword = "sphere",
        .title = "Cosine lobe on the sphere",
        .parameters = {number_parameter(&SphereScheme::exponent, "exp", OwnExponent, 1e6F,
                                        "exponent of the lobe; below 0: the BRDF's own, or 10 if it has none",
                                        grf::ParameterScale::Logarithmic)},
        .description =
            "Samples a cosine lobe about the mirror direction, on the whole sphere: cheaper than "
            "`hemisphere`, and noisier at grazing views, where the samples below the horizon contribute "
            "nothing."};
  }

  static std::string unsupported_reason(const Brdf&) { return {}; }

  void build(const Brdf& brdf) { n_ = exponent >= 0 ? exponent : own_exponents(brdf).about_mirror(); }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    const Vec3f v = cosine_lobe_direction(u, n_, xi.direction);
    return weighted(brdf, u, v, pdf(brdf, u, v));
  }
  float pdf(const Brdf&, const Vec3f& u, const Vec3f& v) const {
    return u.z > 0 && v.z > 0 ? cosine_lobe_pdf(u, v, n_) : 0;
  }

 private:
  float n_ = PlainExponents.about_mirror();
};

}  // namespace reflectance
