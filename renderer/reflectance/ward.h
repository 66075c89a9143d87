#pragma once

#include <cmath>

#include "renderer/reflectance/beckmann_lobe.h"
#include "renderer/reflectance/diffuse_and_lobe.h"
#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct WardFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/ward.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Ward's lobe of Gaussian slopes, fitted to measurements; isotropic if sx = sy.
struct Ward : DiffuseAndLobe<Ward> {
  float sx = 0.2F;
  float sy = 0.2F;
  Rgb ks = Rgb(0.5F);
  Rgb kd = Rgb(0.5F);

  static ModelTable<Ward> table() {
    using grf::ParameterScale;
    Parameter<Ward> y =
        number_parameter(&Ward::sy, "sy", 1e-4F, 10, "RMS slope along y", ParameterScale::Logarithmic);
    y.info.default_from = "sx";
    return {
        .keyword = "ward",
        .title = "Ward",
        .paper = "Ward 1992",
        .parameters = {number_parameter(&Ward::sx, "sx", 1e-4F, 10, "RMS slope along x",
                                        ParameterScale::Logarithmic),
                       y,
                       reflectance_parameter(&Ward::ks, "ks", "albedo of a narrow lobe at normal incidence"),
                       reflectance_parameter(&Ward::kd, "kd", "albedo of the diffuse part")},
        .not_isotropic = "isotropic if sx = sy",
        .not_conserving =
            "the lobe's albedo grows without bound within about 0.3 degrees of grazing, as published",
        .description =
            "Paint, plastic, paper and brushed metal by one Gaussian lobe over a diffuse part, fitted to "
            "measurements. sx and sy are the RMS slopes along and across the tangent: 0.05 is polished, 0.2 "
            "satin, 0.5 dull, and if they differ the highlight is long in the rougher direction. There is no "
            "Fresnel: reflection weakens towards grazing, until it grows without bound in the last fraction "
            "of a degree.",
        .formula = R"(
f = kd/pi + ks exp(-tan(delta)^2 (cos(phi)^2/sx^2 + sin(phi)^2/sy^2)) / (4 pi sx sy sqrt(cu cv))
phi: the azimuth of h)",
        .example = "ward sx=0.2 sy=0.2 ks=0.5 kd=0.5",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::WardFormula<Real>().ward(u, v, Real(sx), Real(sy), Vec3<Real>(ks), Vec3<Real>(kd));
  }

  bool is_anisotropic() const { return sx != sy; }

  // The print has tan(phi_h) = (sx/sy) tan(psi); the exponent asks for sy/sx.
  Vec3f lobe_direction(const Vec3f& u, const Vec2f& xi) const { return beckmann_direction(u, sx, sy, xi); }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const { return beckmann_pdf(u, v, sx, sy); }
  float lobe_ratio(const Vec3f& u, const Vec3f& v) const {
    const Vec3f h = u + v;
    const float cosine = h.z / h.length();
    return cosine_of_half(u, v) * cosine * cosine * cosine * std::sqrt(v.z / u.z);
  }
  float lobe_albedo(const Vec3f&) const { return 1; }
};

}  // namespace reflectance
