#pragma once

#include "renderer/reflectance/beckmann_lobe.h"
#include "renderer/reflectance/diffuse_and_lobe.h"
#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct KajiyaFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/beckmann.glsl"
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/fresnel.glsl"
#include "renderer/reflectance/kajiya.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Anisotropic rough metal: the Kirchhoff approximation in the limit of stationary phase, for a Gaussian
/// surface with correlation exp(-x^2/taux^2 - y^2/tauy^2). The thesis has no formula. The paper has no
/// masking-shadowing and diverges at grazing; Smith's keeps it energy conserving.
struct Kajiya : DiffuseAndLobe<Kajiya> {
  float sigma = 0.2F;
  float taux = 1;
  float tauy = 4;
  float nreal = 0;
  float nimag = 0;
  Rgb ks = Rgb(1);
  Rgb kd = Rgb(0);

  static ModelTable<Kajiya> table() {
    constexpr auto Logarithmic = grf::ParameterScale::Logarithmic;
    return {
        .keyword = "kajiya",
        .title = "Kajiya",
        .paper = "Kajiya 1985",
        .parameters = {number_parameter(&Kajiya::sigma, "sigma", 0, 1e3F,
                                        "rms height; only its ratios to taux and tauy matter", Logarithmic),
                       number_parameter(&Kajiya::taux, "taux", 1e-3F, 1e6F, "correlation length along x",
                                        Logarithmic),
                       number_parameter(&Kajiya::tauy, "tauy", 1e-3F, 1e6F, "correlation length along y",
                                        Logarithmic),
                       number_parameter(&Kajiya::nreal, "nreal", 0, 100,
                                        "index of refraction; 0 is a perfect conductor"),
                       number_parameter(&Kajiya::nimag, "nimag", 0, 100, "its imaginary part, for metals"),
                       reflectance_parameter(&Kajiya::ks, "ks", "weight of the lobe"),
                       reflectance_parameter(&Kajiya::kd, "kd", "albedo of the diffuse part")},
        .not_isotropic = "isotropic if taux = tauy",
        .description =
            "Brushed and rolled metal by wave theory, for roughness large against the wavelength: "
            "microfacets of an anisotropic Gaussian surface. sigma/taux and sigma/tauy are the roughness "
            "along x and y: the highlight is long in the rougher direction. The index of refraction is as "
            "for `torrance`; nreal = 0 is a perfect conductor.",
        .formula = R"(
f = ks F D S(u) S(v)/(4 cu cv) + kd/pi        F = Fresnel(u.h)
D = exp(-tan(delta)^2 (cos(phi)^2/ax^2 + sin(phi)^2/ay^2))/(pi ax ay cos(delta)^4), phi: the azimuth of h
ax = max(1e-4, 2 sigma/taux);  ay the same of tauy;  S: Smith's shadowing of such a surface)",
        .example = "kajiya sigma=0.2 taux=1 tauy=4 nreal=2.485 nimag=3.433",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::KajiyaFormula<Real>().kajiya(u, v, Real(sigma), Real(taux), Real(tauy), Real(nreal),
                                              Real(nimag), Vec3<Real>(ks), Vec3<Real>(kd));
  }

  bool is_anisotropic() const { return taux != tauy; }

  Vec3f lobe_direction(const Vec3f& u, const Vec2f& xi) const {
    return beckmann_direction(u, ax(), ay(), xi);
  }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const { return beckmann_pdf(u, v, ax(), ay()); }
  float lobe_ratio(const Vec3f& u, const Vec3f& v) const {
    glsl::KajiyaFormula<float> formula;
    const float c = cosine_of_half(u, v);
    return formula.fresnel_at_half(u, v, nreal, nimag) * formula.smith_over_cosine(u, ax(), ay()) *
           formula.smith_over_cosine(v, ax(), ay()) * v.z * (2 * c * c / (u.z + v.z));
  }
  float lobe_albedo_estimate(const Vec3f& u) const {
    return glsl::KajiyaFormula<float>().fresnel(u.z, nreal, nimag);
  }

 private:
  float ax() const { return std::max(1e-4F, 2 * sigma / taux); }
  float ay() const { return std::max(1e-4F, 2 * sigma / tauy); }
};

}  // namespace reflectance
