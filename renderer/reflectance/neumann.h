#pragma once

#include <algorithm>
#include <cmath>

#include "renderer/reflectance/diffuse_and_lobe.h"
#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct NeumannFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/neumann.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// A disc lobe: constant where v, projected to the unit disc, is in an ellipse about the mirror direction of
/// u or, for retro, about u. r = 2 is Lambert, r towards 0 a mirror. The edge is a step, at which float,
/// double and GLSL may take different sides.
struct Neumann : DiffuseAndLobe<Neumann> {
  float r = 0.2F;
  float ry = 0.2F;
  bool retro = false;
  Rgb ks = Rgb(1);
  Rgb kd = Rgb(0);

  static ModelTable<Neumann> table() {
    using grf::ParameterScale;
    Parameter<Neumann> y = number_parameter(&Neumann::ry, "ry", 1e-4F, 2, "half axis of the lobe along y",
                                            ParameterScale::Logarithmic);
    y.info.default_from = "r";
    return {
        .keyword = "neumann",
        .title = "Disc lobe",
        .paper = "Neumann and Neumann 1996",
        .parameters = {number_parameter(&Neumann::r, "r", 1e-4F, 2,
                                        "semi-axis of the lobe along x, on the unit disc",
                                        ParameterScale::Logarithmic),
                       y, boolean_parameter(&Neumann::retro, "retro", "whether the lobe is about u itself"),
                       reflectance_parameter(&Neumann::ks, "ks", "albedo of the lobe at normal incidence"),
                       reflectance_parameter(&Neumann::kd, "kd", "albedo of the diffuse part")},
        .not_isotropic = "isotropic if r = ry",
        .not_continuous =
            "it has a step at the edge of the ellipse, where float, double and GLSL may take different sides",
        .description =
            "The simplest reciprocal and energy-conserving lobe: constant inside a disc about the mirror "
            "direction, projected to the unit disc, and 0 outside. r goes from a mirror (towards 0) over a "
            "highlight with a sharp rim to Lambert (2); ry, if it differs, makes it anisotropic, and retro "
            "makes it retro-reflective. Its albedo is ks at normal incidence and never more.",
        .formula = R"(
f = kd/pi + (inside ? ks/A : 0)
inside: ((vx+ux)/r)^2 + ((vy+uy)/ry)^2 <= 1, with - for + where retro is true
A: the area of the ellipse with half axes r and ry that lies in the unit disc)",
        .example = "neumann r=0.2",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::NeumannFormula<Real>().neumann(u, v, Real(r), Real(ry), retro, Vec3<Real>(ks),
                                                Vec3<Real>(kd));
  }

  bool is_anisotropic() const { return r != ry; }

  // Samples a point of the ellipse, or of the whole disc if that is smaller, which is cosine-weighted.
  Vec3f lobe_direction(const Vec3f& u, const Vec2f& xi) const {
    if (is_wide()) return cosine_direction(xi);
    const Vec2f point = to_disc(xi);
    const float x = (retro ? u.x : -u.x) + r * point.x;
    const float y = (retro ? u.y : -u.y) + ry * point.y;
    return {x, y, std::sqrt(std::max(0.0F, 1 - x * x - y * y))};
  }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const {
    if (is_wide()) return cosine_pdf(v);
    return is_inside(u, v) ? v.z / (Pi * r * ry) : 0;
  }
  float lobe_ratio(const Vec3f& u, const Vec3f& v) const {
    return is_inside(u, v) ? Pi * std::min(1.0F, r * ry) / glsl::NeumannFormula<float>().neumann_area(r, ry)
                           : 0;
  }
  float lobe_albedo(const Vec3f&) const { return 1; }

 private:
  bool is_wide() const { return r * ry >= 1; }
  bool is_inside(const Vec3f& u, const Vec3f& v) const {
    return glsl::NeumannFormula<float>().neumann_is_inside(u, v, r, ry, retro);
  }
};

}  // namespace reflectance
