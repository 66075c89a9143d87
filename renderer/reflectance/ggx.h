#pragma once

#include <type_traits>

#include "renderer/reflectance/ggx_facets.h"

namespace reflectance::glsl {

template <class real>
struct GgxFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/facet_fresnel.glsl"
#include "renderer/reflectance/fresnel.glsl"
#include "renderer/reflectance/ggx.glsl"
#include "renderer/reflectance/microfacets.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Rough metals and dielectrics: microfacets of Trowbridge and Reitz's distribution, with Fresnel, Smith's
/// height-correlated masking-shadowing, and the light that facets scatter to each other.
struct Ggx : GgxFacets<Ggx> {
  float alpha = 0.3F;
  float ay = 0.3F;
  float anisotropy = 0;
  float rotation = 0;
  Rgb nreal = Rgb(1.5F);
  Rgb nimag = Rgb(0);
  Rgb f0 = Rgb(0);
  Rgb f82 = Rgb(1);
  Rgb ks = Rgb(1);
  int scattering = 0;

  static ModelTable<Ggx> table() {
    constexpr auto Logarithmic = grf::ParameterScale::Logarithmic;
    Parameter<Ggx> across = number_parameter(&Ggx::ay, "ay", 1e-4F, 1, "roughness along y", Logarithmic);
    across.info.default_from = "alpha";
    return {
        .keyword = "ggx",
        .title = "GGX (Trowbridge-Reitz)",
        .paper = "Trowbridge and Reitz 1975, Walter et al. 2007, Heitz 2014, Kulla and Conty 2017",
        .parameters = {number_parameter(&Ggx::alpha, "alpha", 1e-4F, 1,
                                        "roughness along x, the square of what artists call roughness",
                                        Logarithmic, {"ax"}),
                       across,
                       number_parameter(&Ggx::anisotropy, "anisotropy", 0, 1,
                                        "lengthens the highlight along x, for the same mean roughness"),
                       in_unit("rad", number_parameter(&Ggx::rotation, "rotation", -Pi, Pi,
                                                       "angle from the tangent to x, anticlockwise")),
                       rgb_parameter(&Ggx::nreal, "nreal", 1e-3F, 100, "real part of the index of refraction",
                                     Logarithmic, {"ior"}),
                       rgb_parameter(&Ggx::nimag, "nimag", 0, 100,
                                     "imaginary part of the index of refraction: 0 is a dielectric"),
                       reflectance_parameter(&Ggx::f0, "F0",
                                             "reflectance at normal incidence; 0: by nreal and nimag"),
                       rgb_parameter(&Ggx::f82, "F82", 0.01F, 1,
                                     "with F0, tint of the reflectance at 82 degrees: 1 is Schlick's"),
                       reflectance_parameter(&Ggx::ks, "ks", "factor of the reflection"),
                       word_parameter(&Ggx::scattering, "scattering", {"reciprocal", "scaled", "single"},
                                      "light between facets: a reciprocal lobe of its own (Kulla and Conty), "
                                      "the lobe scaled for the view (Turquin), or none")},
        .not_isotropic = "isotropic if alpha = ay and anisotropy = 0",
        .not_reciprocal = "reciprocal but for scattering=scaled",
        .not_conserving =
            "a white metal reflects up to 1.002, the error of the fitted albedos, and up to 1.07 across a "
            "very anisotropic one",
        .description =
            "The metals, plastics and coats of glTF, OpenPBR, Blender and most renderers since 2007: "
            "microfacets whose highlight has a bright core and a long tail. alpha is the roughness: 0.01 is "
            "polished, 0.1 satin, 0.5 blasted. nreal and nimag, one per channel if they differ, make a "
            "dielectric (1.5 is glass and plastic) or a metal; or F0 is the colour of a metal at normal "
            "incidence and F82 its tint near grazing. Light that facets scatter to each other is kept, so "
            "that rough metals are neither dark nor grey.",
        .formula = R"(
f = ks (F D G/(4 cu cv) + k (1 - E(cu)) (1 - E(cv))/(pi (1 - m)))
D = 1/(pi ax ay ((hx/ax)^2 + (hy/ay)^2 + hz^2)^2)
G = 2 cu cv/(cv S(u) + cu S(v)),  S(u) = sqrt((ax ux)^2 + (ay uy)^2 + uz^2)
F = Fresnel(u.h), or F0 + (1-F0) (1-u.h)^5 - dip u.h (1-u.h)^6
E: the albedo of white facets for a view, m: its mean;  k = Fm^2 m/(1 - Fm (1-m)), Fm: the mean of F)",
        .example = "ggx alpha=0.3 nreal=0.617 nimag=2.63 ks=1",
    };
  }

  /// Computes what depends on the parameters alone, after they were set.
  void prepare() {
    prepare_facets(Formula().ggx_roughness(alpha, ay, anisotropy), Formula().ggx_at_normal(nreal, nimag, f0),
                   Formula().ggx_mean_reflectance(nreal, nimag, f0, f82));
  }
  Ggx() { prepare(); }

  // Inlining all of it saves the copies of colours that are passed by value: a sixth of the time.
  template <class Real>
  [[gnu::flatten]] Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    if constexpr (std::is_same_v<Real, float>) {
      return Formula().ggx_prepared(u, v, rough_, mean_rough_, rotation, nreal, nimag, f0, f82, ks,
                                    scattering, at_normal_, further_);
    } else {
      return glsl::GgxFormula<Real>().ggx(u, v, Real(alpha), Real(ay), Real(anisotropy), Real(rotation),
                                          Vec3<Real>(nreal), Vec3<Real>(nimag), Vec3<Real>(f0),
                                          Vec3<Real>(f82), Vec3<Real>(ks), scattering);
    }
  }

  bool is_anisotropic() const { return alpha != ay || anisotropy != 0; }

  /// Returns Fresnel's reflectance at the half vector.
  Rgb reflectance(const Vec3f& u, const Vec3f& v) const {
    return Formula().ggx_reflectance(u, v, nreal, nimag, f0, f82);
  }

 private:
  using Formula = glsl::GgxFormula<float>;
};

}  // namespace reflectance
