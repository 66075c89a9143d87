#pragma once

#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct DiffuseFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/diffuse.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Lambertian reflection: the same radiance in all directions.
struct Diffuse {
  Rgb kd = Rgb(0.5F);

  static ModelTable<Diffuse> table() {
    return {
        .keyword = "diffuse",
        .title = "Lambert",
        .paper = "Lambert 1760",
        .parameters = {reflectance_parameter(&Diffuse::kd, "kd", "albedo")},
        .description =
            "The ideal diffuse surface: it looks equally bright from everywhere, whatever the light's "
            "direction. kd is its albedo. It is the BRDF of faces without one, with kd = 0.5.",
        .formula = "f = kd/pi",
        .example = "diffuse kd=0.5",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::DiffuseFormula<Real>().diffuse(u, v, Vec3<Real>(kd));
  }

  bool has_glossy_part() const { return false; }
  float albedo_estimate(const Vec3f&) const { return mean(kd); }
  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    const Vec3f v = cosine_direction(xi.direction);
    if (u.z <= 0 || v.z <= 0) return std::nullopt;
    return DirectionSample{v, kd, cosine_pdf(v)};
  }
  float pdf(const Vec3f& u, const Vec3f& v) const { return u.z > 0 ? cosine_pdf(v) : 0; }
};

}  // namespace reflectance
