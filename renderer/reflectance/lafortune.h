#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "renderer/reflectance/cosine_and_lobe.h"
#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct LafortuneFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/lafortune.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// A generalised cosine lobe about (Cx ux, Cy uy, Cz uz): (-1, -1, 1) is Phong's, (1, 1, 1) reflects back,
/// |Cz| < |Cx| is off-specular, Cx != Cy anisotropic. Not normalised: the C's scale the lobe. The mirror
/// direction of u is 2 (u.n) n - u; the print's points into the surface.
struct Lafortune : CosineAndLobe<Lafortune> {
  float n = 20;
  Rgb kp = Rgb(0.5F);
  float cx = -1;
  float cy = -1;
  float cz = 1;

  static ModelTable<Lafortune> table() {
    return {
        .keyword = "lafortune",
        .title = "Generalised cosine lobe",
        .paper = "Lafortune, Foo, Torrance and Greenberg 1997",
        .parameters =
            {number_parameter(&Lafortune::n, "n", 0, 1e6F, "exponent of the lobe",
                              grf::ParameterScale::Logarithmic),
             reflectance_parameter(&Lafortune::kp, "kp", "albedo of the diffuse part", {"kd"}),
             number_parameter(&Lafortune::cx, "Cx", -10, 10, "factor of the lobe's direction along x"),
             number_parameter(&Lafortune::cy, "Cy", -10, 10, "factor of the lobe's direction along y"),
             number_parameter(&Lafortune::cz, "Cz", -10, 10, "factor of the lobe's direction along z")},
        .not_isotropic = "isotropic if Cx = Cy",
        .not_conserving = "the lobe is not normalised: its albedo at normal incidence is 2 pi Cz^n/(n+2)",
        .not_continuous =
            "at the lobe's boundary, for n = 0 it has a step and for n < 1 a steep slope: float, double and "
            "GLSL differ within 1e-6 of it",
        .description =
            "A cosine lobe about any axis, over a diffuse part. (Cx, Cy, Cz) = (-1, -1, 1) is Phong's lobe, "
            "(1, 1, 1) is retro-reflective, |Cz| < |Cx| moves the peak towards the horizon (off-specular), "
            "and Cx != Cy makes it anisotropic. The C's also scale the lobe. Fits to measurements have "
            "several lobes: add them by `combine`.",
        .formula = "f = kp/pi + max(0, Cx ux vx + Cy uy vy + Cz uz vz)^n",
        .example = "lafortune n=100 kp=0.96 Cx=-1 Cy=-1 Cz=1",
    };
  }

  /// Returns an error unless the lobe's peak is at most 1e30.
  std::string validate() const {
    const float largest = formula().lafortune_largest(cx, cy, cz);
    return largest > 0 && n * std::log(largest) > 69
               ? "n log(max(|Cx|, |Cy|, |Cz|)) must be at most 69: the lobe's peak exceeds 1e30"
               : "";
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::LafortuneFormula<Real>().lafortune(u, v, Real(n), Vec3<Real>(kp), Real(cx), Real(cy),
                                                    Real(cz));
  }

  bool has_diffuse_part() const { return !is_black(kp); }
  bool has_glossy_part() const { return true; }
  bool is_anisotropic() const { return cx != cy; }
  LobeExponents lobe_exponents() const { return LobeExponents::about_mirror(n); }

  Rgb diffuse_weight(const Vec3f&, const Vec3f&) const { return kp; }
  float diffuse_albedo(const Vec3f&) const { return mean(kp); }

  // A lobe whose axis is not above the horizon is cosine-weighted.
  Vec3f lobe_direction(const Vec3f& u, const Vec2f& xi) const {
    if (!(cz > 0)) return cosine_direction(xi);
    return Frame(Vec3f(cx * u.x, cy * u.y, cz * u.z).normalized()).to_world(power_direction(n, xi));
  }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const {
    if (!(cz > 0)) return cosine_pdf(v);
    const float log_cosine = formula().lafortune_log_cosine(u, v, cx, cy, cz);
    if (log_cosine < -1e29F) return 0;
    return (n + 1) / (2 * Pi) * std::exp(n * std::min(0.0F, log_cosine - log_length(u)));
  }
  Rgb lobe_weight(const Vec3f& u, const Vec3f& v) const {
    if (!(cz > 0)) return Rgb(formula().lafortune_lobe(u, v, n, cx, cy, cz) * Pi);
    return Rgb(2 * Pi / (n + 1) * strength(u) * v.z);
  }
  float lobe_albedo_estimate(const Vec3f& u) const { return 2 * Pi / (n + 2) * strength(u); }

 private:
  static glsl::LafortuneFormula<float> formula() { return {}; }

  /// The logarithm of the axis' length relative to the largest of the C's.
  float log_length(const Vec3f& u) const {
    const float largest = formula().lafortune_largest(cx, cy, cz);
    const auto lack = [&](float factor, float component) {
      const float ratio = factor / largest;
      return (1 - ratio) * (1 + ratio) * component * component;
    };
    return glsl::log1p(-std::min(1.0F, lack(cx, u.x) + lack(cy, u.y) + lack(cz, u.z))) / 2;
  }
  /// The lobe's peak, the axis' length to the power n.
  float strength(const Vec3f& u) const {
    const float largest = formula().lafortune_largest(cx, cy, cz);
    return largest > 0 ? std::exp(n * (log_length(u) + glsl::log(largest))) : 0;
  }
};

}  // namespace reflectance
