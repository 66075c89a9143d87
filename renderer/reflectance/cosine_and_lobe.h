#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer/reflectance/model.h"

namespace reflectance {

/// The sampler of models with a diffuse part and a lobe: cosine-weighted directions and the lobe's own, each
/// picked with a probability proportional to its estimated albedo. A model derives from it and provides
///   float diffuse_albedo(u)             estimated albedo of what is cosine-weighted,
///   float lobe_albedo_estimate(u)       estimated albedo of what the lobe samples,
///   Vec3f lobe_direction(u, xi)         with xi a Vec2f, or Uniforms if a third number is needed, and its
///   float lobe_pdf(u, v)                solid-angle pdf,
/// and, if the weights have a closed form,
///   Rgb diffuse_weight(u, v)            diffuse part * pi,
///   Rgb lobe_weight(u, v)               lobe cos(theta_v) / lobe_pdf.
template <class Model>
struct CosineAndLobe {
  float albedo_estimate(const Vec3f& u) const {
    return model().diffuse_albedo(u) + model().lobe_albedo_estimate(u);
  }

  float pdf(const Vec3f& u, const Vec3f& v) const {
    if (u.z <= 0 || v.z <= 0) return 0;
    const float cosine_part = cosine_probability(u);
    return cosine_part * cosine_pdf(v) + (1 - cosine_part) * model().lobe_pdf(u, v);
  }

  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    if (u.z <= 0) return std::nullopt;
    const float cosine_part = cosine_probability(u);
    const Vec3f v =
        xi.choice < cosine_part ? cosine_direction(xi.direction) : drawn_from_lobe(u, xi, cosine_part);
    if (!(v.z > 0)) return std::nullopt;
    const float lobe_pdf = model().lobe_pdf(u, v);
    const float pdf = cosine_part * cosine_pdf(v) + (1 - cosine_part) * lobe_pdf;
    if (!(pdf > 0) || !std::isfinite(pdf)) return std::nullopt;
    return DirectionSample{v, weight(u, v, lobe_pdf, pdf), pdf};
  }

 private:
  const Model& model() const { return static_cast<const Model&>(*this); }

  Vec3f drawn_from_lobe(const Vec3f& u, const Uniforms& xi, float cosine_part) const {
    if constexpr (requires { model().lobe_direction(u, xi); }) {
      return model().lobe_direction(u, rescale(xi, cosine_part));
    } else {
      return model().lobe_direction(u, xi.direction);
    }
  }

  // Returns f cos(theta_v) / pdf. In closed form the lobe is its ratio times its pdf, so that no large value
  // is divided by another.
  Rgb weight(const Vec3f& u, const Vec3f& v, float lobe_pdf, float pdf) const {
    if constexpr (requires { model().lobe_weight(u, v); }) {
      return model().diffuse_weight(u, v) * (cosine_pdf(v) / pdf) +
             model().lobe_weight(u, v) * (lobe_pdf / pdf);
    } else {
      return model().evaluate(u, v) * (v.z / pdf);
    }
  }

  static constexpr float LeastProbability = 0.05F;

  // The probability is at least 5 %, so that directions where the lobe's own pdf vanishes are still sampled.
  float cosine_probability(const Vec3f& u) const {
    const float diffuse = model().diffuse_albedo(u);
    if (!(diffuse > 0)) return LeastProbability;
    const float total = diffuse + model().lobe_albedo_estimate(u);
    return std::max(LeastProbability, diffuse / total);
  }
};

}  // namespace reflectance
