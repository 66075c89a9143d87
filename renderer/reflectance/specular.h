#pragma once

#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct SpecularFormula {
  using vec3 = Imath::Vec3<real>;
// GLSL asks for names of parameters that nobody reads, and C++ complains of them.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "renderer/reflectance/specular.glsl"
#pragma GCC diagnostic pop
};

}  // namespace reflectance::glsl

namespace reflectance {

/// An ideal mirror: f is 0, and the Dirac part carries ks. The print's "ks where v = r" has no Dirac and no
/// 1/cos, and would reflect nothing.
struct Specular {
  Rgb ks = Rgb(1);

  static ModelTable<Specular> table() {
    return {
        .keyword = "specular",
        .title = "Ideal mirror",
        .parameters = {reflectance_parameter(&Specular::ks, "ks", "reflectance")},
        .about =
            "An ideal mirror: all that it reflects is in the mirror direction, as a Dirac part, which "
            "sampling picks by itself and which no lobe shows. ks is its reflectance at every angle. A "
            "mirror that brightens towards grazing is `coupled` with Rm = 0, and one with a highlight's "
            "width is `torrance`.",
        .formula = R"(
f = 0
mirror(u) = ks)",
        .example = "specular ks=0.9",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::SpecularFormula<Real>().specular(u, v, Vec3<Real>(ks));
  }

  Rgb mirror(const Vec3f& u) const { return u.z > 1e-12F ? ks : Rgb(0); }
  bool has_glossy_part() const { return false; }
  float albedo_estimate(const Vec3f&) const { return 0; }
  std::optional<DirectionSample> sample(const Vec3f&, const Uniforms&) const { return std::nullopt; }
  float density(const Vec3f&, const Vec3f&) const { return 0; }
};

}  // namespace reflectance
