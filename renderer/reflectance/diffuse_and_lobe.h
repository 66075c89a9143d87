#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer/reflectance/model.h"

namespace reflectance {

/// The sampler of models that are kd/pi + ks * lobe: a cosine part and the lobe's own part, each picked in
/// proportion to its estimated albedo. A model derives from it, has `kd` and `ks`, and gives, for its lobe
/// with ks = 1:
///   Vec3f lobe_direction(u, xi)   drawn with
///   float lobe_density(u, v)      per solid angle,
///   float lobe_ratio(u, v)        lobe cos(theta_v) / lobe_density, in closed form,
///   float lobe_albedo(u)          an estimate.
template <class Model>
struct DiffuseAndLobe {
  float albedo_estimate(const Vec3f& u) const { return mean(model().kd) + lobe_share(u); }

  float density(const Vec3f& u, const Vec3f& v) const {
    if (u.z <= 0 || v.z <= 0) return 0;
    const float cosine_part = cosine_probability(u);
    return cosine_part * cosine_density(v) + (1 - cosine_part) * model().lobe_density(u, v);
  }

  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const {
    if (u.z <= 0) return std::nullopt;
    const float cosine_part = cosine_probability(u);
    const Vec3f v =
        xi.choice < cosine_part ? cosine_direction(xi.direction) : model().lobe_direction(u, xi.direction);
    if (!(v.z > 0)) return std::nullopt;
    const float lobe_density = model().lobe_density(u, v);
    const float density = cosine_part * cosine_density(v) + (1 - cosine_part) * lobe_density;
    if (!(density > 0) || !std::isfinite(density)) return std::nullopt;
    // f cos(theta_v), with the lobe as its ratio times its density: no large value is divided by another.
    const Rgb weight = model().kd * (cosine_density(v) / density) +
                       model().ks * (model().lobe_ratio(u, v) * (lobe_density / density));
    return DirectionSample{v, weight, density};
  }

 private:
  const Model& model() const { return static_cast<const Model&>(*this); }

  float lobe_share(const Vec3f& u) const { return mean(model().ks) * model().lobe_albedo(u); }

  // Never under 5 %, so that no direction in which the BRDF reflects is left out where the lobe's own density
  // vanishes.
  float cosine_probability(const Vec3f& u) const {
    const float diffuse = mean(model().kd);
    const float total = diffuse + lobe_share(u);
    return total > 0 ? std::max(0.05F, diffuse / total) : 1.0F;
  }
};

}  // namespace reflectance
