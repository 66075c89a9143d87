#pragma once

#include "renderer/reflectance/cosine_lobe.h"
#include "renderer/reflectance/diffuse_and_lobe.h"
#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct PhongFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/phong.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// The Phong lobe as published: the specular term is a BRDF value, neither normalised nor divided by the
/// light's cosine (which the rendering equation has). `lewis` is the normalised one.
struct Phong : DiffuseAndLobe<Phong> {
  float n = 100;
  Rgb ks = Rgb(0.4F);
  Rgb kd = Rgb(0.6F);

  static ModelTable<Phong> table() {
    return {
        .keyword = "phong",
        .title = "Phong",
        .paper = "Phong 1975",
        .parameters = {number_parameter(&Phong::n, "n", 0, 1e6F, "exponent of the lobe",
                                        grf::ParameterScale::Logarithmic),
                       reflectance_parameter(&Phong::ks, "ks", "peak of the lobe, in 1/sr: not normalised"),
                       reflectance_parameter(&Phong::kd, "kd", "albedo of the diffuse part")},
        .not_conserving = "the albedo exceeds 1 for kd + 2 pi ks/(n+2) > 1: the lobe is not normalised",
        .not_continuous =
            "at the lobe's boundary, for n = 0 it has a step and for n < 1 a steep slope: float, double and "
            "GLSL differ within 1e-6 of it",
        .description =
            "The first highlight of computer graphics, a lobe about the mirror direction, over a diffuse "
            "part. A larger n makes it smaller and sharper. ks is the lobe's peak and not its albedo: that "
            "is 2 pi ks/(n+2) at normal incidence and less elsewhere, so sharp highlights reflect next to "
            "nothing. `lewis` has the same lobe with an albedo independent of n.",
        .formula = "f = kd/pi + ks max(0, u.r)^n        r: the mirror direction of v",
        .example = "phong n=100 ks=0.4 kd=0.6",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::PhongFormula<Real>().phong(u, v, Real(n), Vec3<Real>(ks), Vec3<Real>(kd));
  }

  LobeExponents lobe_exponents() const { return LobeExponents::about_mirror(n); }

  Vec3f lobe_direction(const Vec3f& u, const Vec2f& xi) const { return cosine_lobe_direction(u, n, xi); }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const { return cosine_lobe_pdf(u, v, n); }
  float lobe_ratio(const Vec3f&, const Vec3f& v) const { return 2 * Pi / (n + 1) * v.z; }
  float lobe_albedo(const Vec3f&) const { return 2 * Pi / (n + 2); }
};

}  // namespace reflectance
