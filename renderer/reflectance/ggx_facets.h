#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer/reflectance/glsl_functions.h"
#include "renderer/reflectance/model.h"

namespace reflectance::glsl {

template <class real>
struct MicrofacetFormula {
  using vec3 = Imath::Vec3<real>;
  static constexpr real PI = Pi<real>;
#include "renderer/reflectance/common.glsl"
#include "renderer/reflectance/fresnel.glsl"
#include "renderer/reflectance/microfacets.glsl"
};

}  // namespace reflectance::glsl

namespace reflectance {

/// Samples visible normals of GGX facets by spherical caps (Dupuy and Benyoub 2023), bounded so that fewer
/// reflections are below the horizon (Tokuyoshi and Eto 2024).
class FacetSampler {
 public:
  /// For the roughness along x and y, and the angle from the tangent to x.
  FacetSampler(const Rgb& rough, float rotation) : rough_(rough), rotation_(rotation) {}

  /// Returns the reflection of u at a visible normal; it may be below the horizon.
  Vec3f direction(const Vec3f& u, const Vec2f& xi) const {
    const Vec3f turned = turn(u);
    const Vec3f view = Vec3f(rough_.x * turned.x, rough_.y * turned.y, turned.z).normalized();
    const float lowest = -visible_part(turned) * view.z;
    const float z = (1 - xi.x) * (1 - lowest) + lowest;
    const float radius = std::sqrt(std::max(0.0F, (1 - z) * (1 + z)));
    const Vec3f cap = from_angles(z, radius, 2 * Pi * xi.y) + view;
    const Vec3f h = Vec3f(rough_.x * cap.x, rough_.y * cap.y, cap.z).normalized();
    return Formula().ggx_turned(reflected(turned, h), -rotation_);
  }
  /// Returns the pdf of that for directions above the horizon.
  float pdf(const Vec3f& u, const Vec3f& v) const {
    const Vec3f turned = turn(u);
    const float projected = visible_part(turned) * turned.z + Formula().ggx_stretched(turned, rough_);
    return Formula().ggx_distribution(turn(u + v), rough_) / (2 * projected);
  }
  /// Returns the value of white facets times cos(theta_v), divided by the pdf: the distribution cancels.
  float ratio(const Vec3f& u, const Vec3f& v) const {
    const Vec3f turned = turn(u);
    const float stretched = Formula().ggx_stretched(turned, rough_);
    const float other = Formula().ggx_stretched(turn(v), rough_);
    return v.z * (visible_part(turned) * u.z + stretched) / (v.z * stretched + u.z * other);
  }

 private:
  using Formula = glsl::MicrofacetFormula<float>;

  Vec3f turn(const Vec3f& u) const { return Formula().ggx_turned(u, rotation_); }
  /// The part of the cap below the view's horizon from which reflections can leave the surface.
  float visible_part(const Vec3f& u) const {
    const float least = std::min({rough_.x, rough_.y, 1.0F});
    const float reach = 1 + std::sqrt(u.x * u.x + u.y * u.y);
    const float square = least * least;
    return (1 - square) * reach * reach / (reach * reach + square * u.z * u.z);
  }

  Rgb rough_;
  float rotation_;
};

/// How the light that facets scatter to each other leaves: by a reciprocal lobe of its own, by scaling the
/// lobe of single reflections for the view, or not at all.
enum FacetScattering { Reciprocal, Scaled, Single };

/// The sampler of GGX microfacets of any reflectance. A model derives from it, has `ks`, `rotation` and
/// `scattering`, calls `prepare_facets`, and provides
///   Rgb reflectance(u, v)    of a facet that reflects v to u.
template <class Model>
class GgxFacets {
 public:
  bool has_diffuse_part() const { return false; }
  bool has_glossy_part() const { return !is_black(model().ks); }

  float albedo_estimate(const Vec3f& u) const {
    const Albedos albedos = albedos_of(u);
    return mean(model().ks) * (albedos.lobe + albedos.further);
  }

  float pdf(const Vec3f& u, const Vec3f& v) const {
    if (u.z <= 0 || v.z <= 0) return 0;
    const float further = further_probability(u);
    return further * further_pdf(v) + (1 - further) * sampler().pdf(u, v);
  }

  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    if (u.z <= 0) return std::nullopt;
    const float further = further_probability(u);
    const Vec3f v =
        xi.choice < further ? further_direction(xi.direction) : sampler().direction(u, xi.direction);
    if (!(v.z > 0)) return std::nullopt;
    const float of_lobe = sampler().pdf(u, v);
    const float density = further * further_pdf(v) + (1 - further) * of_lobe;
    if (!(density > 0) || !std::isfinite(density)) return std::nullopt;
    const Rgb weight = lobe_weight(u, v) * (of_lobe / density) + further_value(u, v) * (v.z / density);
    return DirectionSample{v, weight, density};
  }

 protected:
  /// Sets what depends on the parameters alone: the roughness along x and y, the reflectance at normal
  /// incidence, and its mean over the hemisphere.
  void prepare_facets(const Rgb& rough, const Rgb& at_normal, const Rgb& mean_reflectance) {
    rough_ = rough;
    mean_rough_ = std::sqrt((rough_.x * rough_.x + rough_.y * rough_.y) / 2);
    at_normal_ = at_normal;
    further_ = Formula().ggx_further(mean_reflectance, mean_rough_);
    const float width = mean_rough_ / std::max(1e-3F, 1 - 2 * mean_rough_);
    width2_ = width * width;
    width_logarithm_ = std::log1p(1 / width2_);
  }

  Rgb rough_;             ///< roughness along x and y
  float mean_rough_ = 0;  ///< their quadratic mean
  Rgb at_normal_;         ///< reflectance at normal incidence
  Rgb further_;           ///< factor of the reciprocal lobe

 private:
  using Formula = glsl::MicrofacetFormula<float>;

  const Model& model() const { return static_cast<const Model&>(*this); }
  FacetSampler sampler() const { return {rough_, model().rotation}; }

  /// Estimates of the albedos of the lobe and of what facets scatter to each other, without `ks`.
  struct Albedos {
    float lobe = 0;
    float further = 0;
  };
  Albedos albedos_of(const Vec3f& u) const {
    const float normal = mean(at_normal_);
    const float missing = Formula().ggx_missing(u.z, mean_rough_);
    return {Formula().schlick_fresnel(normal, 1 - u.z) * (1 - missing),
            model().scattering == Reciprocal ? normal * missing : 0};
  }
  float further_probability(const Vec3f& u) const {
    const Albedos albedos = albedos_of(u);
    return albedos.further > 0 ? albedos.further / (albedos.further + albedos.lobe) : 0;
  }

  /// Returns the lobe's value times cos(theta_v), divided by its pdf: the distribution cancels.
  Rgb lobe_weight(const Vec3f& u, const Vec3f& v) const {
    const Rgb weight = model().ks * model().reflectance(u, v) * sampler().ratio(u, v);
    if (model().scattering != Scaled) return weight;
    return weight * (Rgb(1) + at_normal_ * Formula().ggx_several_over_one(u.z, mean_rough_));
  }
  /// The value of what facets scatter to each other.
  Rgb further_value(const Vec3f& u, const Vec3f& v) const {
    if (model().scattering != Reciprocal) return Rgb(0);
    return model().ks * further_ * Formula().ggx_further_lobe(u, v, mean_rough_);
  }
  // Smooth facets scatter to each other near grazing only, at angles of about their slope, and rough ones at
  // all angles: the pdf of the cosine c is proportional to c/(c^2 + width^2).
  Vec3f further_direction(const Vec2f& xi) const {
    const float c = std::min(1.0F, std::sqrt(width2_ * std::expm1(xi.x * width_logarithm_)));
    return from_angles(c, std::sqrt((1 - c) * (1 + c)), 2 * Pi * xi.y);
  }
  float further_pdf(const Vec3f& v) const { return v.z / (Pi * (v.z * v.z + width2_) * width_logarithm_); }

  float width2_ = 0;           ///< squared width of the further lobe's pdf
  float width_logarithm_ = 0;  ///< log(1 + 1/width^2)
};

}  // namespace reflectance
