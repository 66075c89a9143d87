#pragma once

#include "renderer/reflectance/cosine_lobe.h"
#include "renderer/reflectance/diffuse_and_lobe.h"
#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct LewisFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/lewis.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// The normalised Phong lobe: reciprocal, with an albedo of at most kd + ks. It is about the mirror direction
/// and not about h as printed, where the same factor would reflect up to four times the incident light.
struct Lewis : DiffuseAndLobe<Lewis> {
  float n = 100;
  Rgb ks = Rgb(0.4F);
  Rgb kd = Rgb(0.6F);

  static ModelTable<Lewis> table() {
    return {
        .keyword = "lewis",
        .title = "Normalised Phong lobe",
        .paper = "Lewis 1993",
        .parameters = {number_parameter(&Lewis::n, "n", 0, 1e6F, "exponent of the lobe",
                                        grf::ParameterScale::Logarithmic),
                       reflectance_parameter(&Lewis::ks, "ks", "albedo of the lobe at normal incidence"),
                       reflectance_parameter(&Lewis::kd, "kd", "albedo of the diffuse part")},
        .not_continuous =
            "at the lobe's boundary, for n = 0 it has a step and for n < 1 a steep slope: float, double and "
            "GLSL differ within 1e-6 of it",
        .description =
            "Phong's lobe, normalised: ks is the lobe's albedo at normal incidence for every n, so a larger "
            "n makes the highlight both narrower and brighter. The albedo never exceeds kd + ks. For a "
            "narrow lobe it falls as the cosine of the view, so that objects darken towards their "
            "silhouette, where real ones brighten.",
        .formula = "f = kd/pi + ks (n+2)/(2 pi) max(0, u.r)^n        r: the mirror direction of v",
        .example = "lewis n=100 ks=1 kd=0",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::LewisFormula<Real>().lewis(u, v, Real(n), Vec3<Real>(ks), Vec3<Real>(kd));
  }

  LobeExponents lobe_exponents() const { return LobeExponents::about_mirror(n); }

  Vec3f lobe_direction(const Vec3f& u, const Vec2f& xi) const { return cosine_lobe_direction(u, n, xi); }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const { return cosine_lobe_pdf(u, v, n); }
  float lobe_ratio(const Vec3f&, const Vec3f& v) const { return (n + 2) / (n + 1) * v.z; }
  float lobe_albedo(const Vec3f&) const { return 1; }
};

}  // namespace reflectance
