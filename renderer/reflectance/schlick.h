#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct SchlickFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/fresnel.glsl"
#include "renderer/reflectance/schlick.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// The sampling data of one layer, for a Fresnel factor of 1. Facets are sampled by their distribution. Light
/// scattered between facets is sampled uniformly: its value grows as 1/cos(theta_v).
struct SchlickLayer {
  float roughness = 0;  ///< 0: a mirror, with no facets to sample
  float isotropy = 1;

  /// Samples a direction by the distribution of the facets.
  Vec3f facets_direction(const Vec3f& u, const Vec2f& xi) const {
    const float slope = std::sqrt(r() * xi.x / (1 - xi.x));
    const float psi = 2 * Pi * xi.y;
    const float x = p() * std::cos(psi);
    const float y = std::sin(psi);
    const float scale = slope / std::sqrt(x * x + y * y);
    return reflected(u, Vec3f(scale * x, scale * y, 1).normalized());
  }
  /// Returns the solid-angle pdf of `facets_direction`.
  float facets_pdf(const Vec3f& u, const Vec3f& v) const {
    if (!(roughness > 0)) return 0;
    const Vec3f h = u + v;
    const float c = cosine_of_half(u, v);
    const float azimuth = formula().schlick_azimuth(h, p());
    return formula().schlick_zenith(h, r()) * azimuth * azimuth * (u.z + v.z) / (8 * Pi * c * c);
  }
  /// Returns D cos(theta_v) / pdf of the facets.
  float facets_weight(const Vec3f& u, const Vec3f& v) const {
    const float c = cosine_of_half(u, v);
    return 2 * c * c * v.z / (u.z + v.z) / (formula().schlick_azimuth(u + v, p()) * visible(u) * visible(v));
  }
  /// Returns the same weight for light between facets, with uniform directions.
  float between_weight(const Vec3f& u, const Vec3f& v) const {
    if (!(roughness > 0)) return 0;
    return formula().schlick_between_facets(u, v, r()) * v.z / (2 * visible(u) * visible(v));
  }

  /// Returns the albedo of the facets for a view.
  float facets_albedo(const Vec3f& u) const { return roughness > 0 ? u.z / visible(u) : 0; }
  /// Returns the albedo of light scattered between facets.
  float between_albedo(const Vec3f& u) const {
    if (!(roughness > 0)) return 0;
    const float a = 1 - r();
    // The integral of (1 - c)/(r + (1-r) c) over c, as a series where the closed form would cancel.
    const float scattered = a < 0.1F ? 0.5F + a / 3 : (-std::log(r()) / a - 1) / a;
    return r() / (2 * visible(u)) * ((1 - u.z) / u.z + scattered);
  }

 private:
  static glsl::SchlickFormula<float> formula() { return {}; }
  float r() const { return formula().schlick_roughness(roughness); }
  float p() const { return formula().schlick_isotropy(isotropy); }
  float visible(const Vec3f& w) const { return formula().schlick_visible(r(), w.z); }
};

/// One or two layers of facets, each from a mirror to rough, with Fresnel and scattering between facets.
struct Schlick {
  Rgb sc = Rgb(0.7F);
  float sr = 0.31F;
  float sp = 1;
  bool ly = false;
  Rgb dc = Rgb(0.5F);
  float dr = 1;
  float dp = 1;

  static ModelTable<Schlick> table() {
    return {
        .keyword = "schlick",
        .title = "Schlick",
        .paper = "Schlick 1994",
        .parameters =
            {reflectance_parameter(&Schlick::sc, "SC", "reflectance of the layer at normal incidence"),
             number_parameter(&Schlick::sr, "Sr", 0, 1, "roughness: 0 is a mirror"),
             number_parameter(&Schlick::sp, "Sp", 0, 1, "isotropy: 1 is isotropic, less is longer along x"),
             boolean_parameter(&Schlick::ly, "Ly", "whether there is a second layer, under the first"),
             reflectance_parameter(&Schlick::dc, "DC", "reflectance of the second layer at normal incidence"),
             number_parameter(&Schlick::dr, "Dr", 0, 1, "roughness of the second layer"),
             number_parameter(&Schlick::dp, "Dp", 0, 1, "isotropy of the second layer")},
        .not_isotropic = "isotropic if Sp = Dp = 1",
        .not_conserving =
            "light scattered between facets makes the albedo of a rough layer grow as 1/(2 cos(theta)) "
            "towards grazing, as published",
        .description =
            "One layer, or a clear one over another, from a mirror (roughness 0) over satin to diffuse (1), "
            "with Fresnel. SC, Sr and Sp are the layer's reflectance at normal incidence, its roughness and "
            "its isotropy; DC, Dr and Dp those of the second layer, which exists if Ly is true and receives "
            "what the first transmits. The light scattered between facets makes rough layers far too bright "
            "towards grazing.",
        .formula = R"(
f = S D(Sr,Sp), and where Ly is true + (1-S) S' D(Dr,Dp)
S = SC + (1-SC) (1-u.h)^5;  S' the same of DC
D(r,p) = (G(cu) G(cv) Z A + 1 - G(cu) G(cv))/(4 pi cu cv)
G(c) = c/(r + (1-r) c);  Z = r/(1 - (1-r) cos(delta)^2)^2
A = sqrt(p/(p^2 - p^2 w^2 + w^2)), w: the cosine of the azimuth of h
specular_weight(u): S or (1-S) S' at u.h = cu, of each layer whose roughness is 0)",
        .example = "schlick SC=0.7 Sr=0.31 Sp=1 Ly=false",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return glsl::SchlickFormula<Real>().schlick(u, v, Vec3<Real>(sc), Real(sr), Real(sp), ly, Vec3<Real>(dc),
                                                Real(dr), Real(dp));
  }

  Rgb specular_weight(const Vec3f& u) const {
    return u.z > 1e-12F ? glsl::SchlickFormula<float>().schlick_specular(u, sc, sr, ly, dc, dr) : Rgb(0);
  }

  bool has_specular_part() const { return !(sr > 0) || (ly && !(dr > 0)); }
  bool has_diffuse_part() const { return false; }
  bool has_glossy_part() const { return sr > 0 || (ly && dr > 0); }
  bool is_anisotropic() const { return (sr > 0 && sp != 1) || (ly && dr > 0 && dp != 1); }

  float albedo_estimate(const Vec3f& u) const {
    const LobeAlbedos albedos = albedos_of(u);
    return u.z > 1e-12F ? albedos.first + albedos.second + albedos.between : 0;
  }

  float pdf(const Vec3f& u, const Vec3f& v) const {
    if (!(u.z > 1e-12F && v.z > 1e-12F)) return 0;
    const LobeAlbedos p = albedos_of(u).probabilities();
    return p.first * first().facets_pdf(u, v) + p.second * second().facets_pdf(u, v) + p.between * UniformPdf;
  }

  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    if (!(u.z > 1e-12F)) return std::nullopt;
    const LobeAlbedos p = albedos_of(u).probabilities();
    Vec3f v = uniform_direction(xi.direction);
    if (xi.choice < p.first) {
      v = first().facets_direction(u, xi.direction);
    } else if (xi.choice < p.first + p.second) {
      v = second().facets_direction(u, xi.direction);
    }
    const float pdf = this->pdf(u, v);
    if (!(pdf > 0) || !std::isfinite(pdf)) return std::nullopt;
    const Reflectances factors = reflectances(std::min(1.0F, cosine_of_half(u, v)));
    const Rgb weight =
        factors.first * weight_of(first(), u, v, pdf) + factors.second * weight_of(second(), u, v, pdf);
    return DirectionSample{v, weight, pdf};
  }

 private:
  static constexpr float UniformPdf = 1 / (2 * Pi);

  /// Estimated albedos or probabilities of the three sampled lobes.
  struct LobeAlbedos {
    float first = 0;
    float second = 0;
    float between = 0;  ///< of both layers

    // The light between facets gets at least 5 %, since far from the lobes there is nothing else.
    LobeAlbedos probabilities() const {
      const float facets = first + second;
      if (!(facets > 0)) return {0, 0, between > 0 ? 1.0F : 0.0F};
      const float rest = std::max(0.05F, between / (facets + between));
      return {(1 - rest) * (first / facets), (1 - rest) * (second / facets), rest};
    }
  };
  struct Reflectances {
    Rgb first, second;
  };

  SchlickLayer first() const { return {sr, sp}; }
  SchlickLayer second() const { return {ly ? dr : 0, dp}; }

  Reflectances reflectances(float c) const {
    glsl::SchlickFormula<float> formula;
    return {formula.schlick_fresnel(sc, 1 - c), ly ? formula.schlick_second(c, sc, dc) : Rgb(0)};
  }
  LobeAlbedos albedos_of(const Vec3f& u) const {
    const Reflectances weights = reflectances(u.z);
    const float upper = mean(weights.first);
    const float lower = mean(weights.second);
    return {upper * first().facets_albedo(u), lower * second().facets_albedo(u),
            upper * first().between_albedo(u) + lower * second().between_albedo(u)};
  }
  /// Returns D cos(theta_v) / pdf.
  static float weight_of(const SchlickLayer& layer, const Vec3f& u, const Vec3f& v, float pdf) {
    const float facets_pdf = layer.facets_pdf(u, v);
    const float facets = facets_pdf > 0 ? layer.facets_weight(u, v) * (facets_pdf / pdf) : 0;
    return facets + layer.between_weight(u, v) * (UniformPdf / pdf);
  }
};

}  // namespace reflectance
