#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer/reflectance/model.h"

namespace reflectance {

/// The sampler of models that are no plain sum of kd/pi and ks times one lobe (DiffuseAndLobe is for those):
/// a cosine part and a part of the model's own, each picked in proportion to its estimated albedo. A model
/// derives from it and gives
///   float cosine_albedo(u)        what is to be drawn by cosine,
///   float lobe_albedo(u)          what by its own part: estimates both,
///   Vec3f lobe_direction(u, xi)   that part, with xi.choice in [0,1) to choose further, drawn with
///   float lobe_density(u, v)      per solid angle.
template <class Model>
struct CosineAndLobe {
  float albedo_estimate(const Vec3f& u) const { return model().cosine_albedo(u) + model().lobe_albedo(u); }

  float density(const Vec3f& u, const Vec3f& v) const {
    if (u.z <= 0 || v.z <= 0) return 0;
    return density_of(cosine_probability(u), u, v);
  }

  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    if (u.z <= 0) return std::nullopt;
    const float cosine_part = cosine_probability(u);
    const Vec3f v = xi.choice < cosine_part ? cosine_direction(xi.direction)
                                            : model().lobe_direction(u, rest_of(xi, cosine_part));
    if (!(v.z > 0)) return std::nullopt;
    const float density = density_of(cosine_part, u, v);
    if (!(density > 0) || !std::isfinite(density)) return std::nullopt;
    return DirectionSample{v, model().evaluate(u, v) * (v.z / density), density};
  }

 private:
  const Model& model() const { return static_cast<const Model&>(*this); }

  float density_of(float cosine_part, const Vec3f& u, const Vec3f& v) const {
    return cosine_part * cosine_density(v) + (1 - cosine_part) * model().lobe_density(u, v);
  }

  // Never under 5 %, for the directions in which the BRDF reflects and the lobe's density vanishes.
  float cosine_probability(const Vec3f& u) const {
    const float total = albedo_estimate(u);
    return total > 0 ? std::max(0.05F, model().cosine_albedo(u) / total) : 1.0F;
  }
};

}  // namespace reflectance
