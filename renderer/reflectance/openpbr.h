#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "renderer/reflectance/ggx_facets.h"

namespace reflectance::glsl {

template <class real>
struct OpenPbrFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/facet_fresnel.glsl"
#include "renderer/reflectance/fibres.glsl"
#include "renderer/reflectance/film_fresnel.glsl"
#include "renderer/reflectance/fresnel.glsl"
#include "renderer/reflectance/layering.glsl"
#include "renderer/reflectance/microfacets.glsl"
#include "renderer/reflectance/openpbr.glsl"
#include "renderer/reflectance/rough_diffuse.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// The reflection of OpenPBR 1.1.
struct OpenPbr {
  float base_weight = 1;
  Rgb base_colour = Rgb(0.8F);
  float metalness = 0;
  float diffuse_roughness = 0;
  float specular_weight = 1;
  Rgb specular_colour = Rgb(1);
  float roughness = 0.3F;
  float anisotropy = 0;
  float rotation = 0;
  float ior = 1.5F;
  float coat_weight = 0;
  Rgb coat_colour = Rgb(1);
  float coat_roughness = 0;
  float coat_anisotropy = 0;
  float coat_ior = 1.6F;
  float coat_darkening = 1;
  float fuzz_weight = 0;
  Rgb fuzz_colour = Rgb(1);
  float fuzz_roughness = 0.5F;
  float film_weight = 0;
  float film_thickness = 0.5F;
  float film_ior = 1.4F;

  static ModelTable<OpenPbr> table() {
    constexpr auto Linear = grf::ParameterScale::Linear;
    return {
        .keyword = "openpbr",
        .title = "OpenPBR",
        .paper = "Academy Software Foundation 2025, Kulla and Conty 2017",
        .parameters =
            {number_parameter(&OpenPbr::base_weight, "baseWeight", 0, 1, "factor of the base's colour",
                              Linear, {"base_weight"}),
             reflectance_parameter(&OpenPbr::base_colour, "baseColor",
                                   "colour of the metal at normal incidence, and of the diffuse base",
                                   {"base_color"}),
             number_parameter(&OpenPbr::metalness, "metalness", 0, 1, "0: dielectric, 1: metal", Linear,
                              {"base_metalness"}),
             number_parameter(&OpenPbr::diffuse_roughness, "diffuseRough", 0, 1,
                              "roughness of the diffuse base, as of eon", Linear, {"base_diffuse_roughness"}),
             number_parameter(
                 &OpenPbr::specular_weight, "specularWeight", 0, 25,
                 "factor of the dielectric's reflectance at normal incidence, and to 1 of the metal's",
                 Linear, {"specular_weight"}),
             reflectance_parameter(&OpenPbr::specular_colour, "specularColor",
                                   "tint of the dielectric's reflection, and of the metal's at 82 degrees",
                                   {"specular_color"}),
             number_parameter(&OpenPbr::roughness, "roughness", 0, 1,
                              "roughness, the root of the alpha of ggx", Linear, {"specular_roughness"}),
             number_parameter(&OpenPbr::anisotropy, "anisotropy", 0, 1,
                              "lengthens the highlight along x, for the same mean roughness", Linear,
                              {"specular_roughness_anisotropy"}),
             in_unit("rad", number_parameter(&OpenPbr::rotation, "rotation", -Pi, Pi,
                                             "angle from the tangent to x, anticlockwise")),
             number_parameter(&OpenPbr::ior, "ior", 1, 10, "index of refraction of the dielectric", Linear,
                              {"specular_ior"}),
             number_parameter(&OpenPbr::coat_weight, "coatWeight", 0, 1, "part that a coat covers", Linear,
                              {"coat_weight"}),
             reflectance_parameter(&OpenPbr::coat_colour, "coatColor",
                                   "what the coat lets through, in and out, at normal incidence",
                                   {"coat_color"}),
             number_parameter(&OpenPbr::coat_roughness, "coatRoughness", 0, 1, "roughness of the coat",
                              Linear, {"coat_roughness"}),
             number_parameter(&OpenPbr::coat_anisotropy, "coatAnisotropy", 0, 1,
                              "lengthens the coat's highlight along x", Linear,
                              {"coat_roughness_anisotropy"}),
             number_parameter(&OpenPbr::coat_ior, "coatIor", 1, 3, "index of refraction of the coat", Linear,
                              {"coat_ior"}),
             number_parameter(&OpenPbr::coat_darkening, "coatDarkening", 0, 1,
                              "part of the darkening by light that the coat's inside reflects", Linear,
                              {"coat_darkening"}),
             number_parameter(&OpenPbr::fuzz_weight, "fuzzWeight", 0, 1, "part that fibres cover", Linear,
                              {"fuzz_weight"}),
             reflectance_parameter(&OpenPbr::fuzz_colour, "fuzzColor", "colour of the fibres",
                                   {"fuzz_color"}),
             number_parameter(&OpenPbr::fuzz_roughness, "fuzzRoughness", 0.01F, 1,
                              "roughness of the fibres, as of sheen", Linear, {"fuzz_roughness"}),
             number_parameter(&OpenPbr::film_weight, "filmWeight", 0, 1,
                              "part of metal and dielectric that a thin film covers", Linear,
                              {"thin_film_weight"}),
             in_unit("um", number_parameter(&OpenPbr::film_thickness, "filmThickness", 0.01F, 1,
                                            "thickness of the film", Linear, {"thin_film_thickness"})),
             number_parameter(&OpenPbr::film_ior, "filmIor", 1, 3, "index of refraction of the film", Linear,
                              {"thin_film_ior"})},
        .not_isotropic = "isotropic if anisotropy = 0 and coatAnisotropy = 0",
        .not_reciprocal = "reciprocal if fuzzWeight = 0",
        .not_conserving =
            "white reflects up to 1.05 at grazing, the error of the fitted albedos, and up to 1.1 if it is "
            "very anisotropic, or if a film cancels the reflection of a large index of refraction",
        .not_continuous = "as sheen",
        .description =
            "The reflection of OpenPBR 1.1, the material of MaterialX, USD and 3D programs, with its names "
            "without underlines and its ranges; its own names are read too. GGX facets are a metal with a "
            "colour and an edge tint as of ggx, or a dielectric over a rough diffuse base as of eon, or a "
            "mixture; a thin film as of thinfilm, a coat and fibres as of sheen may lie above. Light between "
            "facets is kept. A coat makes the highlight below it wider, the dielectric less reflecting, and "
            "colours darker and more saturated. What is below a layer gets what the layer does not reflect "
            "in either direction, so that the order of the directions does not matter. Transmission, "
            "subsurface scattering, emission and opacity are left out, and a film reflects below a coat as "
            "it does in air.",
        .formula = R"(
f = fuzzWeight fuzzColor fs + (1 - fuzzWeight max(Es(u), Es(v))) (coatWeight Fc DGc + C fb)
fb = (m Fm + (1 - m) specularColor Fd) DG + k (1 - E(u)) (1 - E(v))/(pi (1 - M)) + (1 - m) eon (1 - Ed(u)) (1 - Ed(v))/(1 - Em)
Fm = F of ggx for F0 = baseWeight baseColor and F82 = specularColor;  Fd = Fresnel of (1 + e)/(1 - e)
e = sqrt(specularWeight) (n - 1)/(n + 1);  n = ior (1 - coatWeight + coatWeight/coatIor), or its inverse if that is less
C = (1 - coatWeight + coatWeight (1 - max(Ec(u), Ec(v))) coatColor^((p(u) + p(v))/2)) (1 - coatWeight coatDarkening (1 - d))
d = (1 - K)/(1 - Eb K);  p(u) = 1/sqrt(1 - (1 - cu^2)/coatIor^2);  K: what the coat's inside reflects;  m = metalness
Ed, Ec, Es: albedos of dielectric, coat and fibres;  Eb: the base's at normal incidence;  k, E, M, DG as of ggx;  fs: sheen)",
        .example =
            "openpbr baseColor=(0.6, 0.1, 0.05) metalness=0.5 roughness=0.4 coatWeight=1 coatRoughness=0.3",
    };
  }

  /// Computes what depends on the parameters alone, after they were set.
  void prepare() { surface_ = surface<float>(); }
  OpenPbr() { prepare(); }

  template <class Real>
  [[gnu::flatten]] Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    if constexpr (std::is_same_v<Real, float>) {
      return Formula().openpbr_prepared(u, v, surface_);
    } else {
      return glsl::OpenPbrFormula<Real>().openpbr_prepared(u, v, surface<Real>());
    }
  }

  bool is_anisotropic() const { return anisotropy != 0 || (coat_weight > 0 && coat_anisotropy != 0); }
  bool has_diffuse_part() const { return metalness < 1 || fuzz_weight > 0; }

  float albedo_estimate(const Vec3f& u) const { return albedos_of(u).sum(); }

  float pdf(const Vec3f& u, const Vec3f& v) const {
    if (u.z <= 0 || v.z <= 0) return 0;
    const Albedos albedos = albedos_of(u);
    if (!(albedos.sum() > 0)) return cosine_pdf(v);
    float density = albedos.facets * facets().pdf(u, v) + albedos.rest * cosine_pdf(v);
    if (albedos.coat > 0) density += albedos.coat * coat().pdf(u, v);
    return density / albedos.sum();
  }

  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    if (u.z <= 0) return std::nullopt;
    const Albedos albedos = albedos_of(u);
    const float choice = xi.choice * albedos.sum();
    const Vec3f v = choice < albedos.coat                    ? coat().direction(u, xi.direction)
                    : choice < albedos.coat + albedos.facets ? facets().direction(u, xi.direction)
                                                             : cosine_direction(xi.direction);
    if (!(v.z > 0)) return std::nullopt;
    const float density = pdf(u, v);
    if (!(density > 0) || !std::isfinite(density)) return std::nullopt;
    return DirectionSample{v, evaluate(u, v) * (v.z / density), density};
  }

 private:
  using Formula = glsl::OpenPbrFormula<float>;

  template <class Real>
  typename glsl::OpenPbrFormula<Real>::OpenPbrSurface surface() const {
    using Colour = Vec3<Real>;
    return glsl::OpenPbrFormula<Real>().openpbr_surface(
        Real(base_weight), Colour(base_colour), Real(metalness), Real(diffuse_roughness),
        Real(specular_weight), Colour(specular_colour), Real(roughness), Real(anisotropy), Real(rotation),
        Real(ior), Real(coat_weight), Colour(coat_colour), Real(coat_roughness), Real(coat_anisotropy),
        Real(coat_ior), Real(coat_darkening), Real(fuzz_weight), Colour(fuzz_colour), Real(fuzz_roughness),
        Real(film_weight), Real(film_thickness), Real(film_ior));
  }

  /// Estimates of the albedos of the parts that are sampled: `rest` by the cosine.
  struct Albedos {
    float coat = 0;
    float facets = 0;
    float rest = 0;
    float sum() const { return coat + facets + rest; }
  };
  Albedos albedos_of(const Vec3f& u) const {
    Albedos albedos;
    float below = 1;
    if (fuzz_weight > 0) {
      const float fibres = fuzz_weight * Formula().sheen_albedo(u.z, fuzz_roughness);
      albedos.rest = mean(fuzz_colour) * fibres;
      below = 1 - fibres;
    }
    if (coat_weight > 0) {
      const float reflected = Formula().openpbr_coat_albedo(u.z, surface_.coat_rough, coat_ior);
      albedos.coat = below * coat_weight * reflected;
      below *= 1 - coat_weight + coat_weight * (1 - reflected) * mean(coat_colour);
    }
    const float alpha = surface_.rough.z;
    const float missing = Formula().ggx_missing(u.z, alpha);
    const float normal = mean(surface_.normal);
    const float grazing = mean(specular_colour) * (1 - metalness) + surface_.metal_weight * metalness;
    const float once =
        normal * (1 - missing) + std::max(0.0F, grazing - normal) * Formula().ggx_grazing(u.z, alpha);
    albedos.facets = below * once;
    albedos.rest +=
        below * (normal * missing + (1 - metalness) * mean(surface_.base) * std::max(0.0F, 1 - once));
    return albedos;
  }

  FacetSampler facets() const { return {surface_.rough, rotation}; }
  FacetSampler coat() const { return {surface_.coat_rough, rotation}; }

  Formula::OpenPbrSurface surface_;  ///< what depends on the parameters alone
};

}  // namespace reflectance
