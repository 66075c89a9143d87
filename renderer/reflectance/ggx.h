#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct GgxFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/fresnel.glsl"
#include "renderer/reflectance/ggx.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Rough metals and dielectrics: microfacets of Trowbridge and Reitz's distribution, with Fresnel, Smith's
/// height-correlated masking-shadowing, and the light that facets scatter to each other.
struct Ggx {
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
    rough_ = Formula().ggx_roughness(alpha, ay, anisotropy);
    mean_rough_ = std::sqrt((rough_.x * rough_.x + rough_.y * rough_.y) / 2);
    at_normal_ = Formula().ggx_at_normal(nreal, nimag, f0);
    further_ = Formula().ggx_further_factor(mean_rough_, nreal, nimag, f0, f82);
    const float width = mean_rough_ / std::max(1e-3F, 1 - 2 * mean_rough_);
    width2_ = width * width;
    width_logarithm_ = std::log1p(1 / width2_);
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
  bool has_diffuse_part() const { return false; }
  bool has_glossy_part() const { return !is_black(ks); }

  float albedo_estimate(const Vec3f& u) const {
    const Albedos albedos = albedos_of(u);
    return mean(ks) * (albedos.lobe + albedos.further);
  }

  float pdf(const Vec3f& u, const Vec3f& v) const {
    if (u.z <= 0 || v.z <= 0) return 0;
    const float further = further_probability(u);
    return further * further_pdf(v) + (1 - further) * lobe_pdf(u, v);
  }

  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    if (u.z <= 0) return std::nullopt;
    const float further = further_probability(u);
    const Vec3f v = xi.choice < further ? further_direction(xi.direction) : lobe_direction(u, xi.direction);
    if (!(v.z > 0)) return std::nullopt;
    const float of_lobe = lobe_pdf(u, v);
    const float density = further * further_pdf(v) + (1 - further) * of_lobe;
    if (!(density > 0) || !std::isfinite(density)) return std::nullopt;
    const Rgb weight = lobe_weight(u, v) * (of_lobe / density) + further_value(u, v) * (v.z / density);
    return DirectionSample{v, weight, density};
  }

 private:
  using Formula = glsl::GgxFormula<float>;
  enum Scattering { Reciprocal, Scaled, Single };

  /// Estimates of the albedos of the lobe and of what facets scatter to each other, without `ks`.
  struct Albedos {
    float lobe = 0;
    float further = 0;
  };
  Albedos albedos_of(const Vec3f& u) const {
    const float normal = mean(at_normal_);
    const float missing = Formula().ggx_missing(u.z, mean_rough_);
    return {Formula().schlick_fresnel(normal, 1 - u.z) * (1 - missing),
            scattering == Reciprocal ? normal * missing : 0};
  }
  float further_probability(const Vec3f& u) const {
    const Albedos albedos = albedos_of(u);
    return albedos.further > 0 ? albedos.further / (albedos.further + albedos.lobe) : 0;
  }

  // Samples visible normals by spherical caps (Dupuy and Benyoub 2023), bounded so that fewer reflections are
  // below the horizon (Tokuyoshi and Eto 2024).
  Vec3f lobe_direction(const Vec3f& u, const Vec2f& xi) const {
    const Vec3f turned = Formula().ggx_turned(u, rotation);
    const Vec3f view = Vec3f(rough_.x * turned.x, rough_.y * turned.y, turned.z).normalized();
    const float lowest = -visible_part(turned) * view.z;
    const float z = (1 - xi.x) * (1 - lowest) + lowest;
    const float radius = std::sqrt(std::max(0.0F, (1 - z) * (1 + z)));
    const Vec3f cap = from_angles(z, radius, 2 * Pi * xi.y) + view;
    const Vec3f h = Vec3f(rough_.x * cap.x, rough_.y * cap.y, cap.z).normalized();
    return Formula().ggx_turned(reflected(turned, h), -rotation);
  }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const {
    const Vec3f turned = Formula().ggx_turned(u, rotation);
    const float projected = visible_part(turned) * turned.z + Formula().ggx_stretched(turned, rough_);
    return Formula().ggx_distribution(Formula().ggx_turned(u + v, rotation), rough_) / (2 * projected);
  }
  /// Returns the lobe's value times cos(theta_v), divided by its pdf: the distribution cancels.
  Rgb lobe_weight(const Vec3f& u, const Vec3f& v) const {
    const Vec3f turned = Formula().ggx_turned(u, rotation);
    const float stretched = Formula().ggx_stretched(turned, rough_);
    const float other = Formula().ggx_stretched(Formula().ggx_turned(v, rotation), rough_);
    const float ratio = v.z * (visible_part(turned) * u.z + stretched) / (v.z * stretched + u.z * other);
    const Rgb weight = ks * Formula().ggx_reflectance(u, v, nreal, nimag, f0, f82) * ratio;
    if (scattering != Scaled) return weight;
    return weight * (Rgb(1) + at_normal_ * Formula().ggx_several_over_one(u.z, mean_rough_));
  }
  /// The part of the cap below the view's horizon from which reflections can leave the surface.
  float visible_part(const Vec3f& u) const {
    const float least = std::min({rough_.x, rough_.y, 1.0F});
    const float reach = 1 + std::sqrt(u.x * u.x + u.y * u.y);
    const float square = least * least;
    return (1 - square) * reach * reach / (reach * reach + square * u.z * u.z);
  }

  /// The value of what facets scatter to each other.
  Rgb further_value(const Vec3f& u, const Vec3f& v) const {
    if (scattering != Reciprocal) return Rgb(0);
    return ks * further_ *
           (Formula().ggx_missing(u.z, mean_rough_) * Formula().ggx_missing(v.z, mean_rough_));
  }
  // Smooth facets scatter to each other near grazing only, at angles of about their slope, and rough ones at
  // all angles: the pdf of the cosine c is proportional to c/(c^2 + width^2).
  Vec3f further_direction(const Vec2f& xi) const {
    const float c = std::min(1.0F, std::sqrt(width2_ * std::expm1(xi.x * width_logarithm_)));
    return from_angles(c, std::sqrt((1 - c) * (1 + c)), 2 * Pi * xi.y);
  }
  float further_pdf(const Vec3f& v) const { return v.z / (Pi * (v.z * v.z + width2_) * width_logarithm_); }

  // These depend on the parameters alone.
  Rgb rough_;                  ///< roughness along x and y
  float mean_rough_ = 0;       ///< their quadratic mean
  Rgb at_normal_;              ///< reflectance at normal incidence
  Rgb further_;                ///< factor of the reciprocal lobe
  float width2_ = 0;           ///< squared width of the further lobe's pdf
  float width_logarithm_ = 0;  ///< log(1 + 1/width^2)
};

}  // namespace reflectance
