#pragma once

#include "renderer/reflectance/cosine_lobe.h"
#include "renderer/reflectance/schemes/lobe_exponent.h"
#include "renderer/reflectance/schemes/weighted.h"

namespace reflectance {

/// A cosine lobe about the mirror direction, on the whole sphere: what is under the horizon is drawn and
/// counts as zero, so the density's mass over the hemisphere is under 1.
struct SphereScheme {
  static constexpr bool MayMiss = true;

  float exponent = OwnExponent;

  static ModelTable<SphereScheme> table() {
    return {
        .keyword = "sphere",
        .title = "Cosine lobe on the sphere",
        .parameters = {number_parameter(&SphereScheme::exponent, "exp", OwnExponent, 1e6F,
                                        "exponent of the lobe; below 0: the BRDF's own, or 10 if it has none",
                                        grf::ParameterScale::Logarithmic)},
        .about =
            "A cosine lobe about the mirror direction, on the whole sphere: cheaper than `hemisphere`, and "
            "noisier at grazing views, where the samples under the horizon carry nothing."};
  }

  static std::string refusal(const Brdf&) { return {}; }

  void build(const Brdf& brdf) { n_ = exponent >= 0 ? exponent : own_exponents(brdf).about_mirror(); }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    const Vec3f v = cosine_lobe_direction(u, n_, xi.direction);
    return weighted(brdf, u, v, density(brdf, u, v));
  }
  float density(const Brdf&, const Vec3f& u, const Vec3f& v) const {
    return u.z > 0 && v.z > 0 ? cosine_lobe_density(u, v, n_) : 0;
  }

 private:
  float n_ = PlainExponents.about_mirror();
};

}  // namespace reflectance
