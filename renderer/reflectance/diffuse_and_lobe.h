#pragma once

#include "renderer/reflectance/cosine_and_lobe.h"

namespace reflectance {

/// The sampler of models of the form kd/pi + ks * lobe. A model derives from it, has `kd` and `ks`, and
/// provides for its lobe with ks = 1
///   Vec3f lobe_direction(u, xi)         as in CosineAndLobe, and its
///   float lobe_pdf(u, v)                solid-angle pdf,
///   float lobe_ratio(u, v)              lobe cos(theta_v) / lobe_pdf, in closed form,
///   float lobe_albedo(u)                estimated albedo.
template <class Model>
struct DiffuseAndLobe : CosineAndLobe<Model> {
  Rgb diffuse_weight(const Vec3f&, const Vec3f&) const { return model().kd; }
  float diffuse_albedo(const Vec3f&) const { return mean(model().kd); }
  Rgb lobe_weight(const Vec3f& u, const Vec3f& v) const { return model().ks * model().lobe_ratio(u, v); }
  float lobe_albedo_estimate(const Vec3f& u) const { return mean(model().ks) * model().lobe_albedo(u); }

 private:
  const Model& model() const { return static_cast<const Model&>(*this); }
};

}  // namespace reflectance
