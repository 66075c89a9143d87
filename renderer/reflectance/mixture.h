// Sampling of models that are kd/pi + ks * lobe: a cosine part and the lobe's own part, each picked in
// proportion to its estimated albedo. A model gives, for its lobe with ks = 1:
//   Vec3f lobe_direction(u, xi)   drawn with
//   float lobe_density(u, v)      per solid angle,
//   float lobe_ratio(u, v)        lobe cos(theta_v) / lobe_density, in closed form,
//   float lobe_albedo(u)          an estimate.
#pragma once

#include <algorithm>
#include <optional>

#include "renderer/reflectance/model.h"

namespace reflectance {

/// The probability of the cosine part. Never under 5 %, so that no direction in which the BRDF reflects is
/// left out where the lobe's own density vanishes.
template <class Model>
float cosine_share(const Model& model, const Vec3f& u) {
  const float diffuse = mean(model.kd);
  const float total = diffuse + mean(model.ks) * model.lobe_albedo(u);
  return total > 0 ? std::max(0.05F, diffuse / total) : 1.0F;
}

template <class Model>
float mixture_albedo(const Model& model, const Vec3f& u) {
  return mean(model.kd) + mean(model.ks) * model.lobe_albedo(u);
}

template <class Model>
float mixture_density(const Model& model, const Vec3f& u, const Vec3f& v) {
  if (u.z <= 0 || v.z <= 0) return 0;
  const float share = cosine_share(model, u);
  return share * cosine_density(v) + (1 - share) * model.lobe_density(u, v);
}

template <class Model>
std::optional<DirectionSample> sample_mixture(const Model& model, const Vec3f& u, const Uniforms& xi) {
  if (u.z <= 0) return std::nullopt;
  const float share = cosine_share(model, u);
  const Vec3f v = xi.choice < share ? cosine_direction(xi.direction) : model.lobe_direction(u, xi.direction);
  if (!(v.z > 0)) return std::nullopt;
  const float lobe_density = model.lobe_density(u, v);
  const float density = share * cosine_density(v) + (1 - share) * lobe_density;
  if (!(density > 0) || !std::isfinite(density)) return std::nullopt;
  // f cos(theta_v), with the lobe as its ratio times its density: no large value is divided by another.
  const Rgb reflected = model.kd * (cosine_density(v) / density) +
                        model.ks * (model.lobe_ratio(u, v) * (lobe_density / density));
  return DirectionSample{v, reflected, density};
}

}  // namespace reflectance
