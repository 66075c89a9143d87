#pragma once

#include <type_traits>

#include "renderer/reflectance/ggx_facets.h"

namespace reflectance::glsl {

template <class real>
struct ThinFilmFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/film_fresnel.glsl"
#include "renderer/reflectance/fresnel.glsl"
#include "renderer/reflectance/microfacets.glsl"
#include "renderer/reflectance/thinfilm.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Rough metals and dielectrics under a thin film, whose two sides' reflections interfere.
struct ThinFilm : GgxFacets<ThinFilm> {
  float alpha = 0.1F;
  float ay = 0.1F;
  float thickness = 300;
  float film = 1.33F;
  Rgb nreal = Rgb(1.5F);
  Rgb nimag = Rgb(0);
  Rgb ks = Rgb(1);

  static constexpr float rotation = 0;
  static constexpr FacetScattering scattering = Reciprocal;

  static ModelTable<ThinFilm> table() {
    constexpr auto Logarithmic = grf::ParameterScale::Logarithmic;
    Parameter<ThinFilm> across =
        number_parameter(&ThinFilm::ay, "ay", 1e-4F, 1, "roughness along the bitangent", Logarithmic);
    across.info.default_from = "alpha";
    return {
        .keyword = "thinfilm",
        .title = "Thin film on GGX",
        .paper = "Airy 1833, Belcour and Barla 2017",
        .parameters = {number_parameter(&ThinFilm::alpha, "alpha", 1e-4F, 1,
                                        "roughness along the tangent, as of ggx", Logarithmic, {"ax"}),
                       across,
                       in_unit("nm",
                               number_parameter(&ThinFilm::thickness, "thickness", 1, 1000,
                                                "thickness of the film", grf::ParameterScale::Linear, {"d"})),
                       number_parameter(&ThinFilm::film, "film", 1, 3, "index of refraction of the film"),
                       rgb_parameter(&ThinFilm::nreal, "nreal", 1e-3F, 100,
                                     "real part of the base's index of refraction: 1 is air", Logarithmic,
                                     {"ior"}),
                       rgb_parameter(&ThinFilm::nimag, "nimag", 0, 100,
                                     "imaginary part of the base's index of refraction: 0 is a dielectric"),
                       reflectance_parameter(&ThinFilm::ks, "ks", "factor of the reflection")},
        .not_isotropic = "isotropic if alpha = ay",
        .not_conserving =
            "a nearly white film reflects up to 1.002, and up to 1.07 if it is very anisotropic",
        .description =
            "Soap bubbles, oil on water, tempered steel, anodised titanium, pearls and beetles: the light "
            "that "
            "both sides of a film reflect interferes, and the colour changes with the thickness and the "
            "angle. "
            "The base is a metal or a dielectric, as of ggx: nreal=1 is a film in air, a bubble. The colour "
            "is "
            "a sum over 28 wavelengths from 385 to 720 nm, under light of equal energy; for films of up to "
            "500 "
            "nm it is within 0.003 of a fine sum, up to 1000 nm within 0.007. Colours beyond sRGB are "
            "clamped.",
        .formula = R"(
f = ks (F D G/(4 cu cv) + k (1 - E(cu)) (1 - E(cv))/(pi (1 - m))), D, G, E, m and k as of ggx
F = sum over wavelengths of w(l) (|r_s|^2 + |r_p|^2)/2,  r = (a + b e)/(1 + a b e)
e = exp(4 pi i thickness sqrt(film^2 - sin^2)/l), a: amplitude at the film's front, b: at its base)",
        .example = "thinfilm alpha=0.1 thickness=350 film=1.5 nreal=2.5 nimag=3.4 ks=1",
    };
  }

  /// Computes what depends on the parameters alone, after they were set.
  void prepare() {
    prepare_facets(Rgb(alpha, ay, 0), Formula().film_reflectance(1, 0, thickness, film, nreal, nimag),
                   Formula().film_mean(thickness, film, nreal, nimag));
  }
  ThinFilm() { prepare(); }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    if constexpr (std::is_same_v<Real, float>) {
      return Formula().thinfilm_prepared(u, v, rough_, mean_rough_, thickness, film, nreal, nimag, ks,
                                         further_);
    } else {
      return glsl::ThinFilmFormula<Real>().thinfilm(u, v, Real(alpha), Real(ay), Real(thickness), Real(film),
                                                    Vec3<Real>(nreal), Vec3<Real>(nimag), Vec3<Real>(ks));
    }
  }

  bool is_anisotropic() const { return alpha != ay; }

  /// Returns the film's reflectance at the half vector.
  Rgb reflectance(const Vec3f& u, const Vec3f& v) const {
    return Formula().film_at_half(u, v, thickness, film, nreal, nimag);
  }

 private:
  using Formula = glsl::ThinFilmFormula<float>;
};

}  // namespace reflectance
