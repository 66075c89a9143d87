#pragma once

#include <cmath>
#include <optional>

#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct SheenFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/fibres.glsl"
#include "renderer/reflectance/sheen.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// The sheen of cloth: a layer of fibres that scatters light many times, mostly towards grazing.
struct Sheen {
  float rough = 0.3F;
  Rgb ks = Rgb(1);

  static ModelTable<Sheen> table() {
    return {
        .keyword = "sheen",
        .title = "LTC sheen",
        .paper = "Zeltner, Burley and Chiang 2022",
        .parameters = {number_parameter(&Sheen::rough, "rough", 0.01F, 1,
                                        "roughness of the fibres' directions (the paper's alpha)"),
                       reflectance_parameter(&Sheen::ks, "ks", "colour of the fibres")},
        .not_reciprocal = "the fit is of one view at a time, as published",
        .not_continuous =
            "the fit of the albedo falls to 0 for thin fibres from above, and there only rounding is left",
        .description =
            "Cloth, velvet, dust and peach skin: the shine of fibres that stand on a surface, strongest "
            "towards grazing. rough is small for a thin bright rim (0.1), and large for a pile that shines "
            "all over (0.8). There is nothing below the fibres: add a diffuse base in a combine.",
        .formula = R"(
f = ks R(cu) a^2/(pi (x^2 + y^2 + cv^2)^2)
x = a sin(theta_v) cos(phi) + b cv;  y = a sin(theta_v) sin(phi);  phi: the azimuth of v from that of u
R: the albedo for a view;  a, b: functions of cu and rough that are fitted to simulated fibres)",
        .example = "sheen rough=0.3 ks=1",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::SheenFormula<Real>().sheen(u, v, Real(rough), Vec3<Real>(ks));
  }

  bool has_diffuse_part() const { return false; }

  float albedo_estimate(const Vec3f& u) const { return mean(ks) * Formula().sheen_albedo(u.z, rough); }

  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    if (u.z <= 0) return std::nullopt;
    const Vec3f cosine = cosine_direction(xi.direction);
    const float scale = Formula().sheen_scale(u.z, rough);
    const float shear = Formula().sheen_shear(u.z, rough);
    // The shear is along the view's azimuth, by its sine.
    const Vec3f v = Vec3f((cosine.x - u.x * shear * cosine.z) / scale,
                          (cosine.y - u.y * shear * cosine.z) / scale, cosine.z)
                        .normalized();
    const float density = pdf(u, v);
    if (!(density > 0) || !std::isfinite(density)) return std::nullopt;
    return DirectionSample{v, ks * Formula().sheen_albedo(u.z, rough), density};
  }
  float pdf(const Vec3f& u, const Vec3f& v) const {
    return u.z > 0 && v.z > 0 ? v.z * Formula().sheen_lobe(u, v, rough) : 0;
  }

 private:
  using Formula = glsl::SheenFormula<float>;
};

}  // namespace reflectance
