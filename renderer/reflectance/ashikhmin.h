#pragma once

#include <algorithm>
#include <cmath>

#include "renderer/reflectance/cosine_and_lobe.h"
#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct AshikhminFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/ashikhmin.glsl"
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/fresnel.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Reflects u at a half vector sampled from its anisotropic power (Ashikhmin and Shirley 2000). The azimuth
/// comes from one number, so no quadrant is chosen. The result may be below the horizon. The print has v = u
/// + 2(u.h)h, which is right for a u that points into the surface.
inline Vec3f anisotropic_lobe_direction(const Vec3f& u, const LobeExponents& e, const Vec2f& xi) {
  // tan(phi_h) = sqrt((ex+1)/(ey+1)) tan(psi), of which only the cosine and sine are needed.
  const float psi = 2 * Pi * xi.y;
  const float x = std::sqrt(e.y + 1) * std::cos(psi);
  const float y = std::sqrt(e.x + 1) * std::sin(psi);
  const float length2 = x * x + y * y;
  const float exponent = (e.x * x * x + e.y * y * y) / length2;
  const float one_minus_cos = -std::expm1(std::log1p(-xi.x) / (exponent + 1));
  const float sine = std::sqrt(one_minus_cos * (2 - one_minus_cos) / length2);
  return reflected(u, Vec3f(sine * x, sine * y, 1 - one_minus_cos));
}

/// Returns the solid-angle pdf of `anisotropic_lobe_direction`.
inline float anisotropic_lobe_pdf(const Vec3f& u, const Vec3f& v, const LobeExponents& e) {
  return std::sqrt((e.x + 1) * (e.y + 1)) / (8 * Pi) *
         glsl::AshikhminFormula<float>().ashikhmin_power(u + v, e.x, e.y) / cosine_of_half(u, v);
}

/// An anisotropic Phong lobe with Fresnel over a diffuse part that reflects what the lobe leaves.
struct Ashikhmin : CosineAndLobe<Ashikhmin> {
  float ex = 25;
  float ey = 25;
  Rgb rs = Rgb(0.39F);
  Rgb rd = Rgb(0.6F);

  static ModelTable<Ashikhmin> table() {
    using grf::ParameterScale;
    Parameter<Ashikhmin> y = number_parameter(&Ashikhmin::ey, "ey", 0, 1e6F, "exponent of the lobe along y",
                                              ParameterScale::Logarithmic, {"nv"});
    y.info.default_from = "ex";
    return {
        .keyword = "ashikhmin",
        .title = "Ashikhmin-Shirley",
        .paper = "Ashikhmin and Shirley 2000",
        .parameters = {number_parameter(&Ashikhmin::ex, "ex", 0, 1e6F, "exponent of the lobe along x",
                                        ParameterScale::Logarithmic, {"nu"}),
                       y,
                       reflectance_parameter(&Ashikhmin::rs, "Rs",
                                             "reflectance of a facet at normal incidence", {"ks"}),
                       reflectance_parameter(&Ashikhmin::rd, "Rd", "reflectance of the diffuse part",
                                             {"kd"})},
        .not_isotropic = "isotropic if ex = ey",
        .description =
            "Brushed metal and polished plastic from few, intuitive parameters: an anisotropic Phong lobe "
            "that strengthens towards grazing as Fresnel reflection does, over a diffuse part that fades by "
            "as much. ex and ey are the exponents along and across the tangent (10 is dull, 1000 polished), "
            "Rs the lobe's reflectance at normal incidence, Rd that of the diffuse part.",
        .formula = R"(
f = sqrt((ex+1)(ey+1))/(8 pi) cos(delta)^e F/((u.h) max(cu, cv))
    + 28 Rd (1-Rs)/(23 pi) (1 - (1-cu/2)^5) (1 - (1-cv/2)^5)
e = ex cos(phi)^2 + ey sin(phi)^2, phi: the azimuth of h;  F = Rs + (1-Rs) (1-u.h)^5)",
        .example = "ashikhmin ex=25 ey=25 Rs=0.39 Rd=0.6",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return formula<Real>().ashikhmin(u, v, Real(ex), Real(ey), Vec3<Real>(rs), Vec3<Real>(rd));
  }

  bool has_diffuse_part() const { return !is_black(rd); }
  bool has_glossy_part() const { return true; }
  bool is_anisotropic() const { return ex != ey; }

  Rgb diffuse_weight(const Vec3f& u, const Vec3f& v) const {
    return formula<float>().ashikhmin_diffuse(u, v, rs, rd) * Pi;
  }
  float diffuse_albedo(const Vec3f&) const { return mean(rd * (Rgb(1) - rs)); }

  Vec3f lobe_direction(const Vec3f& u, const Vec2f& xi) const {
    return anisotropic_lobe_direction(u, {ex, ey}, xi);
  }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const { return anisotropic_lobe_pdf(u, v, {ex, ey}); }
  Rgb lobe_weight(const Vec3f& u, const Vec3f& v) const {
    return formula<float>().schlick_fresnel(rs, 1 - std::min(1.0F, cosine_of_half(u, v))) *
           (v.z / std::max(u.z, v.z));
  }
  float lobe_albedo_estimate(const Vec3f& u) const {
    return mean(formula<float>().schlick_fresnel(rs, 1 - u.z));
  }

 private:
  template <class Real>
  static glsl::AshikhminFormula<Real> formula() {
    return {};
  }
};

}  // namespace reflectance
