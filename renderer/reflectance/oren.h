#pragma once

#include <optional>

#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct OrenFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/oren.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Rough diffuse surfaces: Lambertian facets in V-grooves, which brighten towards the light's own direction
/// (backscattering). The print has integrals over the grooves; this is the paper's fit for rendering. As
/// published, unbounded for pairs that graze in the same direction, with a bounded albedo.
struct Oren {
  float s = 0.3F;
  Rgb r = Rgb(0.5F);

  static ModelTable<Oren> table() {
    const Parameter<Oren> slope = in_unit(
        "rad",
        number_parameter(&Oren::s, "s", 0, 1, "standard deviation of the facets' slope angle: 0 is Lambert"));
    return {
        .keyword = "oren",
        .title = "Oren-Nayar",
        .paper = "Oren and Nayar 1994",
        .parameters = {slope, reflectance_parameter(&Oren::r, "r", "albedo of the facets")},
        .not_conserving = "the fit reflects up to 1.05 for r = 1, towards grazing",
        .not_continuous =
            "for light that grazes from the far side the fit falls below 0 and is clamped; near that its "
            "terms cancel, and differ by 1e-7 of the peak",
        .description =
            "Rough diffuse surfaces such as plaster, clay and sand: Lambertian facets with shadowing, "
            "masking and interreflection. s is the roughness, from Lambert (0) to very rough (0.5 and more), "
            "and r the albedo of the facets. The rougher it is, the flatter an object looks and the brighter "
            "towards the light's direction (backscattering).",
        .formula = R"(
f = max(0, r/pi (L1 + L2))
alpha, beta: the larger and the smaller of theta_u and theta_v;  c = cos(phi_u - phi_v);  q = s^2/(s^2 + 0.09)
L1 = 1 - 0.5 s^2/(s^2 + 0.33) + c C2 tan(beta) + (1-|c|) C3 tan((alpha+beta)/2)
L2 = 0.17 r s^2/(s^2 + 0.13) (1 - c (2 beta/pi)^2)
C2 = 0.45 q (sin(alpha) - (c < 0 ? (2 beta/pi)^3 : 0));  C3 = 0.125 q (4 alpha beta/pi^2)^2)",
        .example = "oren s=0.4 r=0.9",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::OrenFormula<Real>().oren(u, v, Real(s), Vec3<Real>(r));
  }

  bool has_diffuse_part() const { return !is_black(r); }
  bool has_glossy_part() const { return false; }

  float albedo_estimate(const Vec3f&) const { return mean(r); }
  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    const Vec3f v = cosine_direction(xi.direction);
    if (u.z <= 0 || v.z <= 0) return std::nullopt;
    return DirectionSample{v, evaluate(u, v) * Pi, cosine_pdf(v)};
  }
  float pdf(const Vec3f& u, const Vec3f& v) const { return u.z > 0 ? cosine_pdf(v) : 0; }
};

}  // namespace reflectance
