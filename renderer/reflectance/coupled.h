#pragma once

#include <optional>

#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct CoupledFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/coupled.glsl"
#include "renderer/reflectance/fresnel.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Polished diffuse surfaces such as paint and plastic: a mirror of Fresnel reflectance R over a diffuse part
/// that reflects the rest. With Rm = 1 they sum to 1 at every angle.
struct Coupled {
  Rgb rm = Rgb(0.5F);
  Rgb r0 = Rgb(0.05F);

  static ModelTable<Coupled> table() {
    return {
        .keyword = "coupled",
        .title = "Polished diffuse",
        .paper = "Shirley, Hu, Smits and Lafortune 1997",
        .parameters = {reflectance_parameter(&Coupled::rm, "Rm", "reflectance of the diffuse part"),
                       rgb_parameter(&Coupled::r0, "R0", 0, 0.999F,
                                     "specular reflectance at normal incidence", grf::ParameterScale::Linear,
                                     {"Ro"})},
        .description =
            "Glossy paint, glazed ceramics and varnished wood: a smooth dielectric coat over a diffuse base. "
            "Towards grazing the specular reflection strengthens and the diffuse part fades by as much, so "
            "that with Rm = 1 they reflect exactly 1 at every angle. Rm is the diffuse colour, R0 the "
            "specular reflectance at normal incidence (0.03 to 0.06 for dielectrics).",
        .formula = R"(
f = 21 (1-R0)/(20 pi) Rm (1 - (1-cu)^5) (1 - (1-cv)^5)
specular_weight(u) = R0 + (1-R0) (1-cu)^5)",
        .example = "coupled Rm=1 R0=0.05",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::CoupledFormula<Real>().coupled(u, v, Vec3<Real>(rm), Vec3<Real>(r0));
  }

  Rgb specular_weight(const Vec3f& u) const {
    return u.z > 1e-12F ? glsl::CoupledFormula<float>().coupled_specular(u, r0) : Rgb(0);
  }

  bool has_diffuse_part() const { return !is_black(rm); }
  bool has_glossy_part() const { return false; }

  float albedo_estimate(const Vec3f& u) const {
    return mean(rm * glsl::CoupledFormula<float>().schlick_transmittance(r0, u.z));
  }
  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    const Vec3f v = cosine_direction(xi.direction);
    if (u.z <= 0 || v.z <= 0) return std::nullopt;
    return DirectionSample{v, evaluate(u, v) * Pi, cosine_pdf(v)};
  }
  float pdf(const Vec3f& u, const Vec3f& v) const { return u.z > 0 ? cosine_pdf(v) : 0; }
};

}  // namespace reflectance
