#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer/reflectance/model.h"

namespace reflectance {

/// The sampler of models with a diffuse part and a lobe: cosine-weighted directions and the lobe's own, each
/// picked with a probability proportional to its estimated albedo. A model derives from it and provides
///   float matte_albedo(u)         estimated albedo of what is cosine-weighted,
///   float lobe_share(u)           estimated albedo of what the lobe samples,
///   Vec3f lobe_direction(u, xi)   with xi a Vec2f, or Uniforms if a third number is needed, and its
///   float lobe_density(u, v)      solid-angle pdf,
/// and, if the weights have a closed form,
///   Rgb matte_weight(u, v)        diffuse part * pi,
///   Rgb lobe_weight(u, v)         lobe cos(theta_v) / lobe_density.
template <class Model>
struct CosineAndLobe {
  float albedo_estimate(const Vec3f& u) const { return model().matte_albedo(u) + model().lobe_share(u); }

  float density(const Vec3f& u, const Vec3f& v) const {
    if (u.z <= 0 || v.z <= 0) return 0;
    const float cosine_part = cosine_probability(u);
    return cosine_part * cosine_density(v) + (1 - cosine_part) * model().lobe_density(u, v);
  }

  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    if (u.z <= 0) return std::nullopt;
    const float cosine_part = cosine_probability(u);
    const Vec3f v =
        xi.choice < cosine_part ? cosine_direction(xi.direction) : drawn_from_lobe(u, xi, cosine_part);
    if (!(v.z > 0)) return std::nullopt;
    const float lobe_density = model().lobe_density(u, v);
    const float density = cosine_part * cosine_density(v) + (1 - cosine_part) * lobe_density;
    if (!(density > 0) || !std::isfinite(density)) return std::nullopt;
    return DirectionSample{v, weight(u, v, lobe_density, density), density};
  }

 private:
  const Model& model() const { return static_cast<const Model&>(*this); }

  Vec3f drawn_from_lobe(const Vec3f& u, const Uniforms& xi, float cosine_part) const {
    if constexpr (requires { model().lobe_direction(u, xi); }) {
      return model().lobe_direction(u, rest_of(xi, cosine_part));
    } else {
      return model().lobe_direction(u, xi.direction);
    }
  }

  // Returns f cos(theta_v) / pdf. In closed form the lobe is its ratio times its pdf, so that no large value
  // is divided by another.
  Rgb weight(const Vec3f& u, const Vec3f& v, float lobe_density, float density) const {
    if constexpr (requires { model().lobe_weight(u, v); }) {
      return model().matte_weight(u, v) * (cosine_density(v) / density) +
             model().lobe_weight(u, v) * (lobe_density / density);
    } else {
      return model().evaluate(u, v) * (v.z / density);
    }
  }

  static constexpr float LeastProbability = 0.05F;

  // The probability is at least 5 %, so that directions where the lobe's own pdf vanishes are still sampled.
  float cosine_probability(const Vec3f& u) const {
    const float matte = model().matte_albedo(u);
    if (!(matte > 0)) return LeastProbability;
    const float total = matte + model().lobe_share(u);
    return std::max(LeastProbability, matte / total);
  }
};

}  // namespace reflectance
