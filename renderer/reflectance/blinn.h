#pragma once

#include "renderer/reflectance/diffuse_and_lobe.h"
#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/half_power_lobe.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct BlinnFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/blinn.glsl"
#include "renderer/reflectance/common.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Blinn-Phong: the lobe (n.h)^n, not normalised. Blinn's own microfacet model of 1977 is `torrance`.
struct Blinn : DiffuseAndLobe<Blinn> {
  float n = 100;
  Rgb ks = Rgb(0.4F);
  Rgb kd = Rgb(0.6F);

  static ModelTable<Blinn> table() {
    return {
        .keyword = "blinn",
        .title = "Blinn-Phong",
        .paper = "Blinn 1977",
        .parameters = {number_parameter(&Blinn::n, "n", 0, 1e6F, "exponent of the lobe",
                                        grf::ParameterScale::Logarithmic),
                       reflectance_parameter(&Blinn::ks, "ks", "peak of the lobe, in 1/sr: not normalised"),
                       reflectance_parameter(&Blinn::kd, "kd", "albedo of the diffuse part")},
        .not_conserving =
            "the albedo exceeds 1 for kd + 8 pi ks (n+2^(-n/2))/((n+2)(n+4)) > 1: the lobe is not normalised",
        .description =
            "Phong's lobe, as a function of the half vector: its highlights stretch towards grazing, as "
            "those of real surfaces do. For the same n it is twice as wide as `phong` and reflects four "
            "times as much; ks is again the lobe's peak. Blinn's own microfacet model of 1977 is `torrance`.",
        .formula = "f = kd/pi + ks cos(delta)^n",
        .example = "blinn n=100 ks=1 kd=0.67",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::BlinnFormula<Real>().blinn(u, v, Real(n), Vec3<Real>(ks), Vec3<Real>(kd));
  }

  Vec3f lobe_direction(const Vec3f& u, const Vec2f& xi) const { return reflected(u, power_direction(n, xi)); }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const { return half_power_pdf(u, v, n); }
  float lobe_ratio(const Vec3f& u, const Vec3f& v) const {
    return 8 * Pi * cosine_of_half(u, v) / (n + 1) * v.z;
  }
  float lobe_albedo(const Vec3f&) const {
    return std::min(1.0F, 8 * Pi * (n + std::exp2(-n / 2)) / ((n + 2) * (n + 4)));
  }
};

}  // namespace reflectance
