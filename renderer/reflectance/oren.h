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

/// Rough diffuse: Lambert facets in V-grooves, which brighten what lies in the light's own direction. The
/// print has the integrals over the grooves; this is the fit that the paper gives for rendering. As
/// published: unbounded for pairs that graze in the same direction, with a bounded albedo.
struct Oren {
  float s = 0.3F;
  Rgb r = Rgb(0.5F);

  static ModelTable<Oren> table() {
    Parameter<Oren> slope =
        number_parameter(&Oren::s, "s", 0, 1, "standard deviation of the facets' slope angle: 0 is Lambert");
    slope.info.unit = "rad";
    return {
        "oren",
        "Oren-Nayar",
        "Oren and Nayar 1994",
        {slope, reflectance_parameter(&Oren::r, "r", "albedo of the facets")},
        {},
        {},
        "the fit reflects up to 1.05 for r = 1, towards grazing",
        "where light grazes from the far side the fit falls under 0 and is cut; near that its terms cancel, "
        "and differ by 1e-7 of the peak"};
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
    return DirectionSample{v, evaluate(u, v) * Pi, cosine_density(v)};
  }
  float density(const Vec3f& u, const Vec3f& v) const { return u.z > 0 ? cosine_density(v) : 0; }
};

}  // namespace reflectance
