#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "renderer/reflectance/ggx_facets.h"

namespace reflectance::glsl {

template <class real>
struct GltfFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/fibres.glsl"
#include "renderer/reflectance/film_fresnel.glsl"
#include "renderer/reflectance/fresnel.glsl"
#include "renderer/reflectance/gltf.glsl"
#include "renderer/reflectance/layering.glsl"
#include "renderer/reflectance/microfacets.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// The material of glTF 2.0.
struct Gltf {
  Rgb base = Rgb(1);
  float metallic = 0;
  float roughness = 0.5F;
  float ior = 1.5F;
  float specular = 1;
  Rgb specular_colour = Rgb(1);
  float anisotropy = 0;
  float rotation = 0;
  float clearcoat = 0;
  float coat_roughness = 0;
  Rgb sheen_colour = Rgb(0);
  float sheen_roughness = 0.3F;
  float iridescence = 0;
  float iridescence_ior = 1.3F;
  float film_thickness = 400;

  static ModelTable<Gltf> table() {
    return {
        .keyword = "gltf",
        .title = "glTF metallic-roughness",
        .paper = "Khronos 2021, Kulla and Conty 2017",
        .parameters =
            {reflectance_parameter(&Gltf::base, "baseColor", "colour of the metal, and of the diffuse part"),
             number_parameter(&Gltf::metallic, "metallic", 0, 1, "0: dielectric, 1: metal"),
             number_parameter(&Gltf::roughness, "roughness", 0, 1, "roughness, the root of the alpha of ggx"),
             number_parameter(&Gltf::ior, "ior", 1, 10, "index of refraction of the dielectric"),
             number_parameter(&Gltf::specular, "specular", 0, 1, "factor of the dielectric's reflection"),
             rgb_parameter(&Gltf::specular_colour, "specularColor", 0, 25,
                           "colour of the dielectric's reflection at normal incidence"),
             number_parameter(&Gltf::anisotropy, "anisotropy", 0, 1, "lengthens the highlight along x"),
             in_unit("rad", number_parameter(&Gltf::rotation, "rotation", -Pi, Pi,
                                             "angle from the tangent to x, anticlockwise")),
             number_parameter(&Gltf::clearcoat, "clearcoat", 0, 1, "strength of a clear coat"),
             number_parameter(&Gltf::coat_roughness, "coatRoughness", 0, 1, "roughness of the coat",
                              grf::ParameterScale::Linear, {"clearcoatRoughness"}),
             reflectance_parameter(&Gltf::sheen_colour, "sheenColor", "colour of fibres on the surface"),
             number_parameter(&Gltf::sheen_roughness, "sheenRoughness", 0.01F, 1,
                              "roughness of the fibres, as of sheen"),
             number_parameter(&Gltf::iridescence, "iridescence", 0, 1, "strength of a thin film"),
             number_parameter(&Gltf::iridescence_ior, "iridescenceIor", 1, 3,
                              "index of refraction of the film"),
             in_unit("nm", number_parameter(&Gltf::film_thickness, "filmThickness", 10, 1000,
                                            "thickness of the film", grf::ParameterScale::Linear,
                                            {"iridescenceThicknessMaximum"}))},
        .not_isotropic = "isotropic if anisotropy = 0",
        .not_reciprocal = "reciprocal if sheenColor = 0",
        .not_conserving = "white reflects up to 1.015 at grazing, the error of the fitted albedos",
        .not_continuous = "as sheen",
        .description =
            "The material of glTF files, with the extensions ior, specular, anisotropy, iridescence, sheen "
            "and "
            "clearcoat, and their names and ranges. GGX facets are a metal of the base's colour, or a "
            "dielectric over a "
            "diffuse base, or a mixture. As the format permits, energy is kept: light between facets is not "
            "lost, and the diffuse base, and all that is below fibres or a coat, gets what the layer above "
            "does not reflect. Fibres are those of sheen, not of the format's Charlie lobe. "
            "A film is that of thinfilm, over a dielectric of the same reflectance at normal incidence.",
        .formula = R"(
f = cc S(0.04) DG + (1 - cc max(Ec(u), Ec(v))) (sheenColor fs + (1 - s max(Es(u), Es(v))) fb)
fb = F DG + k (1 - E(u)) (1 - E(v))/(pi (1 - m)) + (1 - metallic) baseColor/pi (1 - Ed(u)) (1 - Ed(v))/(1 - Em)
F = S(F0) of the dielectric, or S(baseColor) of the metal;  S(x) = x + (S90 - x) (1 - u.h)^5
F0 = specular min(1, specularColor ((ior-1)/(ior+1))^2);  DG = D G/(4 cu cv), k, E, m as of ggx
with iridescence, S is mixed with F of thinfilm over the index (1 + sqrt(x))/(1 - sqrt(x))
Ec, Es, Ed: albedos of the coat, the fibres and the dielectric;  Em: the mean of Ed;  fs: sheen)",
        .example =
            "gltf baseColor=(0.8, 0.25, 0.1) metallic=0 roughness=0.35 clearcoat=0.5 coatRoughness=0.4",
    };
  }

  /// Computes what depends on the parameters alone, after they were set.
  void prepare() {
    rough_ = Formula().gltf_rough(roughness, anisotropy);
    normal_ = Formula().gltf_normal(ior, specular, specular_colour);
    film_ = Rgb(iridescence, iridescence_ior, film_thickness);
    const auto means = Formula().gltf_mean_reflectances(base, normal_, specular, film_);
    further_ = Formula().gltf_further(means, metallic, rough_.z);
    dielectric_ = Formula().gltf_dielectric(normal_, specular, means.dielectric, rough_.z, film_);
    at_normal_ = of_facets(normal_, base);
    if (iridescence > 0) {
      const auto facets = Formula().gltf_reflectances(base, normal_, specular, 1, 0, film_);
      at_normal_ = of_facets(facets.dielectric, facets.metal);
    }
    coat_rough_ = Formula().gltf_rough(coat_roughness, 0);
  }
  Gltf() { prepare(); }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    if constexpr (std::is_same_v<Real, float>) {
      return Formula().gltf_prepared(u, v, rough_, rotation, base, metallic, normal_, specular, clearcoat,
                                     coat_rough_, sheen_colour, sheen_roughness, film_, further_,
                                     dielectric_);
    } else {
      return glsl::GltfFormula<Real>().gltf(
          u, v, Vec3<Real>(base), Real(metallic), Real(roughness), Real(ior), Real(specular),
          Vec3<Real>(specular_colour), Real(anisotropy), Real(rotation), Real(clearcoat),
          Real(coat_roughness), Vec3<Real>(sheen_colour), Real(sheen_roughness), Real(iridescence),
          Real(iridescence_ior), Real(film_thickness));
    }
  }

  bool is_anisotropic() const { return anisotropy != 0; }
  bool has_diffuse_part() const { return metallic < 1; }

  float albedo_estimate(const Vec3f& u) const {
    const Albedos albedos = albedos_of(u);
    return albedos.coat + albedos.facets + albedos.rest;
  }

  float pdf(const Vec3f& u, const Vec3f& v) const {
    if (u.z <= 0 || v.z <= 0) return 0;
    const Albedos albedos = albedos_of(u);
    const float sum = albedos.coat + albedos.facets + albedos.rest;
    if (!(sum > 0)) return cosine_pdf(v);
    float density = albedos.facets * facets().pdf(u, v) + albedos.rest * cosine_pdf(v);
    if (albedos.coat > 0) density += albedos.coat * coat().pdf(u, v);
    return density / sum;
  }

  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    if (u.z <= 0) return std::nullopt;
    const Albedos albedos = albedos_of(u);
    const float choice = xi.choice * (albedos.coat + albedos.facets + albedos.rest);
    const Vec3f v = choice < albedos.coat                    ? coat().direction(u, xi.direction)
                    : choice < albedos.coat + albedos.facets ? facets().direction(u, xi.direction)
                                                             : cosine_direction(xi.direction);
    if (!(v.z > 0)) return std::nullopt;
    const float density = pdf(u, v);
    if (!(density > 0) || !std::isfinite(density)) return std::nullopt;
    return DirectionSample{v, evaluate(u, v) * (v.z / density), density};
  }

 private:
  using Formula = glsl::GltfFormula<float>;

  /// Estimates of the albedos of the parts that are sampled: `rest` by the cosine.
  struct Albedos {
    float coat = 0;
    float facets = 0;
    float rest = 0;
  };
  Albedos albedos_of(const Vec3f& u) const {
    Albedos albedos;
    float below = 1;
    if (clearcoat > 0) {
      albedos.coat = std::min(1.0F, clearcoat * Formula().gltf_coat_albedo(u.z, coat_rough_.z));
      below = 1 - albedos.coat;
    }
    if (!is_black(sheen_colour)) {
      const float fibres = Formula().sheen_albedo(u.z, sheen_roughness);
      albedos.rest = below * mean(sheen_colour) * fibres;
      below *= 1 - std::min(1.0F, Formula().largest_channel(sheen_colour) * fibres);
    }
    const Rgb& normal = at_normal_;
    const float grazing = specular + (1 - specular) * metallic;
    const float missing = Formula().ggx_missing(u.z, rough_.z);
    const float facets =
        mean(normal) * (1 - missing) + (grazing - mean(normal)) * Formula().ggx_grazing(u.z, rough_.z);
    albedos.facets = below * std::max(0.0F, facets);
    albedos.rest +=
        below * (mean(normal) * missing + (1 - metallic) * mean(base) * std::max(0.0F, 1 - facets));
    return albedos;
  }

  /// Returns what is between the dielectric and the metal.
  Rgb of_facets(const Rgb& of_dielectric, const Rgb& of_metal) const {
    return of_dielectric + (of_metal - of_dielectric) * metallic;
  }

  FacetSampler facets() const { return {rough_, rotation}; }
  FacetSampler coat() const { return {coat_rough_, 0}; }

  // These depend on the parameters alone.
  Rgb rough_;       ///< roughness along x and y, and their quadratic mean
  Rgb coat_rough_;  ///< the coat's
  Rgb normal_;      ///< reflectance of the dielectric at normal incidence
  Rgb at_normal_;   ///< reflectance of the facets at normal incidence
  Rgb film_;        ///< strength, index of refraction and thickness of the film
  Rgb further_;     ///< factor of the lobe of light between facets
  Rgb dielectric_;  ///< see gltf.glsl
};

}  // namespace reflectance
