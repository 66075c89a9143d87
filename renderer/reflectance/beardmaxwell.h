#pragma once

#include <cmath>

#include "renderer/reflectance/cosine_and_lobe.h"
#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct BeardMaxwellFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/beardmaxwell.glsl"
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/fresnel.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Painted surfaces: a rough first surface over a scattering volume, in the form of the NEF data base
/// (Westlund and Meyer 2002), with volume functions of 1. Two terms differ from the thesis' print, which
/// divides the first surface by the cosines twice and the volume by their product instead of their sum.
struct BeardMaxwell : CosineAndLobe<BeardMaxwell> {
  float omega = 1;
  float tau = 0;
  float nreal = 1.65F;
  float nimag = 0;
  Rgb rs = Rgb(1);
  Rgb rd = Rgb(0.3F);
  Rgb rv = Rgb(0.1F);
  float sigma = 0.3F;

  static ModelTable<BeardMaxwell> table() {
    using Self = BeardMaxwell;
    constexpr auto Logarithmic = grf::ParameterScale::Logarithmic;
    return {
        .keyword = "beardmaxwell",
        .title = "Beard-Maxwell",
        .paper = "Maxwell, Beard, Weiner, Ladd and Ward 1973; Westlund and Meyer 2002",
        .parameters =
            {in_unit("rad",
                     number_parameter(&Self::omega, "omega", 1e-6F, 1e6F, "angle of shadowing", Logarithmic)),
             in_unit("rad",
                     number_parameter(&Self::tau, "tau", 0, 1e6F, "angle of obscuration", Logarithmic)),
             number_parameter(&Self::nreal, "nreal", 0, 100, "index of refraction of the first surface"),
             number_parameter(&Self::nimag, "nimag", 0, 100, "its imaginary part, for metals"),
             reflectance_parameter(&Self::rs, "Rs", "weight of the first surface"),
             reflectance_parameter(&Self::rd, "Rd", "albedo of the diffuse part"),
             reflectance_parameter(&Self::rv, "Rv",
                                   "reflectance factor of the volume at normal incidence and view"),
             number_parameter(
                 &Self::sigma, "sigma", 1e-3F, 10,
                 "width of the microfacet distribution: the tangent at which D cos has fallen to half",
                 Logarithmic)},
        .not_conserving =
            "the first surface grows as 1/(cos cos) towards grazing, as published, and the volume reflects "
            "1.227 Rv at normal and up to 4 Rv at grazing incidence",
        .description =
            "Painted surfaces, as in the NEF data base: a rough first surface, volume scattering in the "
            "paint, and a Lambertian part. Rs, Rv and Rd are their weights and sigma the width of the "
            "highlight, whose tails are long. omega and tau control shadowing and obscuration away from the "
            "mirror direction. There is no masking-shadowing in the mirror direction, so it gains energy "
            "towards grazing.",
        .formula = R"(
f = Rs F(u.h) D S/(4 cu cv) + Rd/pi + Rv/pi 2/(cu + cv)        F = Fresnel(u.h) of nreal + i nimag
D = B/(cos(delta) (sigma^2 + tan(delta)^2)), B such that the integral of D cos(delta) over h is 1
S = (1 + delta/omega exp(-2 beta/tau))/(1 + delta/omega), beta: the angle of u and h; tau = 0: 1/(1 + delta/omega))",
        .example = "beardmaxwell omega=1 tau=0 nreal=0.37 nimag=2.82 Rs=0.4 Rd=0.75 Rv=0.5",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::BeardMaxwellFormula<Real>().beardmaxwell(u, v, Real(omega), Real(tau), Real(nreal),
                                                          Real(nimag), Vec3<Real>(rs), Vec3<Real>(rd),
                                                          Vec3<Real>(rv), Real(sigma));
  }

  bool has_diffuse_part() const { return !is_black(rd); }
  bool has_glossy_part() const { return !is_black(rs) || !is_black(rv); }

  float diffuse_albedo(const Vec3f&) const { return mean(rd); }
  float lobe_albedo_estimate(const Vec3f& u) const { return surface_albedo(u) + volume_albedo(); }

  // Samples the facets, or the volume lobe 1/(cos + cos), for which uniform directions suffice.
  Vec3f lobe_direction(const Vec3f& u, const Uniforms& xi) const {
    const float phi = 2 * Pi * xi.direction.y;
    const float x = xi.direction.x;
    if (xi.choice >= surface_probability(u)) return from_angles(1 - x, std::sqrt(x * (2 - x)), phi);
    // D cos has no closed inverse. This pdf has its tails: sigma/(2 pi (sigma^2 + tan^2)^(3/2) cos^3).
    const float tangent = sigma * std::sqrt(x * (2 - x)) / (1 - x);
    const float cosine = 1 / std::sqrt(1 + tangent * tangent);
    return reflected(u, from_angles(cosine, tangent * cosine, phi));
  }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const {
    const Vec3f h = u + v;
    const float c = cosine_of_half(u, v);
    const float scaled = std::sqrt(sigma * sigma * h.z * h.z + h.x * h.x + h.y * h.y) / (2 * c);
    const float facets = sigma / (2 * Pi * scaled * scaled * scaled) / (4 * c);
    const float surface = surface_probability(u);
    return surface * facets + (1 - surface) / (2 * Pi);
  }

 private:
  float volume_albedo() const { return 1.2F * mean(rv); }
  // The estimate grows towards grazing as the model does.
  float surface_albedo(const Vec3f& u) const {
    const float c = 0.5F + 0.5F * u.z;
    return mean(rs) * glsl::BeardMaxwellFormula<float>().fresnel(c, nreal, nimag) *
           (1 + 1 / std::max(u.z, 0.05F)) / 2;
  }
  float surface_probability(const Vec3f& u) const {
    const float surface = surface_albedo(u);
    const float total = surface + volume_albedo();
    return total > 0 ? surface / total : 1;
  }
};

}  // namespace reflectance
