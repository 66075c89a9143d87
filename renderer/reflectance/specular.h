#pragma once

#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct SpecularFormula {
  using vec3 = Imath::Vec3<real>;
// GLSL requires names of unused parameters, and C++ warns of them.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "renderer/reflectance/specular.glsl"
#pragma GCC diagnostic pop
};

}  // namespace reflectance::glsl

namespace reflectance {

/// An ideal mirror: f is 0, and the delta part has weight ks. The print's "ks where v = r" has no Dirac delta
/// and no 1/cos, and would reflect nothing.
struct Specular {
  Rgb ks = Rgb(1);

  static ModelTable<Specular> table() {
    return {
        .keyword = "specular",
        .title = "Ideal mirror",
        .parameters = {reflectance_parameter(&Specular::ks, "ks", "reflectance")},
        .description =
            "An ideal mirror: a delta distribution in the mirror direction, which sampling picks with its "
            "own probability and which lobe plots do not show. ks is its reflectance at every angle. For a "
            "mirror with Fresnel use `coupled` with Rm = 0, and for one with a highlight of some width "
            "`torrance`.",
        .formula = R"(
f = 0
specular_weight(u) = ks)",
        .example = "specular ks=0.9",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::SpecularFormula<Real>().specular(u, v, Vec3<Real>(ks));
  }

  Rgb specular_weight(const Vec3f& u) const { return u.z > 1e-12F ? ks : Rgb(0); }
  bool has_glossy_part() const { return false; }
  float albedo_estimate(const Vec3f&) const { return 0; }
  std::optional<DirectionSample> sample(const Vec3f&, const Uniforms&) const { return std::nullopt; }
  float pdf(const Vec3f&, const Vec3f&) const { return 0; }
};

}  // namespace reflectance
