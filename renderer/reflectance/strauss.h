#pragma once

#include "renderer/reflectance/cosine_and_lobe.h"
#include "renderer/reflectance/cosine_lobe.h"
#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct StraussFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/strauss.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Metals and plastics from two parameters, smoothness and metalness. kd is the colour that Strauss gives a
/// surface.
struct Strauss : CosineAndLobe<Strauss> {
  float s = 0.5F;
  float m = 0;
  Rgb ks = Rgb(0.5F);
  Rgb kd = Rgb(0.5F);

  static ModelTable<Strauss> table() {
    return {
        .keyword = "strauss",
        .title = "Strauss",
        .paper = "Strauss 1990",
        .parameters = {number_parameter(&Strauss::s, "s", 0, 1, "smoothness: 0 is diffuse, 1 a mirror"),
                       number_parameter(&Strauss::m, "m", 0, 1,
                                        "metalness: 1 has no diffuse part and a coloured lobe"),
                       reflectance_parameter(&Strauss::ks, "ks", "factor of the lobe"),
                       reflectance_parameter(&Strauss::kd, "kd",
                                             "factor of the diffuse part, and the colour of a metal")},
        .not_reciprocal = "its Fresnel factor depends only on the light's angle, as published",
        .not_conserving = "reflects up to 1.004 for ks = kd = 1 and m = 0",
        .description =
            "Metals and plastics from two parameters: smoothness s goes from diffuse to mirror, metalness m "
            "from plastic, with a white highlight over a coloured body, to metal, with only a coloured "
            "highlight. kd is the surface's colour, ks the highlight's strength. Fresnel depends only on the "
            "light's angle, so the model is not reciprocal.",
        .formula = R"(
f = kd (1 - m s) (1 - s^3)/pi + ks C rj (e+2)/(2 pi) max(0, u.r)^e        e = min(3/(1-s), 1e5)
rj = min(1, s^3 + (s^3 + 0.1) F(theta_v) G(theta_v) G(theta_u));  r: the mirror direction of v
C = 1 + m (1 - F(theta_v)) (kd/max(kd) - 1)
F rises from 0 at the normal to 1 at the horizon: (1/(x-1.12)^2 - 1/1.12^2)/(1/0.12^2 - 1/1.12^2), x = theta/(pi/2)
G falls from 1 to 0: (1/0.01^2 - 1/(x-1.01)^2)/(1/0.01^2 - 1/1.01^2))",
        .example = "strauss s=0.76 m=0.91 ks=0.64 kd=0.5",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::StraussFormula<Real>().strauss(u, v, Real(s), Real(m), Vec3<Real>(ks), Vec3<Real>(kd));
  }

  bool has_diffuse_part() const { return diffuse_albedo(Vec3f()) > 0; }

  Rgb diffuse_weight(const Vec3f&, const Vec3f&) const { return kd * formula().strauss_diffuse(s, m); }
  float diffuse_albedo(const Vec3f&) const { return mean(kd) * formula().strauss_diffuse(s, m); }

  Vec3f lobe_direction(const Vec3f& u, const Vec2f& xi) const {
    return cosine_lobe_direction(u, exponent(), xi);
  }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const { return cosine_lobe_pdf(u, v, exponent()); }
  Rgb lobe_weight(const Vec3f& u, const Vec3f& v) const {
    return ks * formula().strauss_reflectivity(u, v, s, m, kd) * ((exponent() + 2) / (exponent() + 1) * v.z);
  }
  float lobe_albedo_estimate(const Vec3f& u) const {
    return mean(ks * formula().strauss_reflectivity(u, mirrored(u), s, m, kd));
  }

 private:
  static glsl::StraussFormula<float> formula() { return {}; }
  float exponent() const { return formula().strauss_exponent(s); }
};

}  // namespace reflectance
