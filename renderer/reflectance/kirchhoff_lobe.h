#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer/reflectance/beckmann_lobe.h"
#include "renderer/reflectance/cosine_and_lobe.h"
#include "renderer/reflectance/model.h"

namespace reflectance {

/// The parameters that `he` and `westin` share.
template <class Model>
std::vector<Parameter<Model>> kirchhoff_parameters() {
  constexpr auto Logarithmic = grf::ParameterScale::Logarithmic;
  return {number_parameter(&Model::sigma, "sigma", 0, 1e3F, "rms height, in micrometres", Logarithmic),
          number_parameter(&Model::tau, "tau", 1e-3F, 1e6F, "autocorrelation length, in micrometres",
                           Logarithmic),
          rgb_parameter(&Model::lambda, "lambda", 1, 1e6F, "wavelength, in nanometres", Logarithmic),
          number_parameter(&Model::nreal, "nreal", 0, 100, "index of refraction; 0 is a perfect conductor"),
          number_parameter(&Model::nimag, "nimag", 0, 100, "its imaginary part, for metals"),
          reflectance_parameter(&Model::ks, "ks", "weight of the mirror and the directional-diffuse part"),
          reflectance_parameter(&Model::kd, "kd", "albedo of the diffuse part")};
}

/// The sampler of `he` and `westin`: Beckmann half vectors. Their width is that of the lobe where the surface
/// is rough in wavelengths, and that of the series' first term, the only one that is left, where it is
/// smooth. In between the further terms are wider: a part of the half vectors is, and a tenth is drawn by
/// cosine.
template <class Model>
struct KirchhoffLobe : CosineAndLobe<Model> {
  bool has_glossy_part() const { return !is_black(model().ks) && model().sigma > 0; }

  float cosine_albedo(const Vec3f& u) const { return mean(model().kd) + 0.1F * rough_albedo(u); }
  float lobe_albedo(const Vec3f& u) const { return 0.9F * rough_albedo(u); }

  Vec3f lobe_direction(const Vec3f& u, const Uniforms& xi) const {
    const float a = width(u) * (xi.choice < WideShare ? WideFactor : 1);
    return beckmann_direction(u, a, a, xi.direction);
  }
  float lobe_density(const Vec3f& u, const Vec3f& v) const {
    const float a = width(u);
    return (1 - WideShare) * beckmann_density(u, v, a, a) +
           WideShare * beckmann_density(u, v, WideFactor * a, WideFactor * a);
  }

 private:
  static constexpr float WideShare = 0.25F;
  static constexpr float WideFactor = 2;

  const Model& model() const { return static_cast<const Model&>(*this); }

  // By the longest wavelength, whose lobe is the widest.
  float width(const Vec3f& u) const {
    const float rough = 2 * model().sigma / model().tau;
    const float diffracted = largest(model().lambda) / (2000 * Pi * model().tau * std::max(u.z, 1e-6F));
    return std::clamp(std::hypot(rough, diffracted), 1e-6F, 1e6F);
  }
  // What the Dirac part leaves.
  float rough_albedo(const Vec3f& u) const {
    const float height = 4000 * Pi * model().sigma * u.z / mean(model().lambda);
    return mean(model().ks) * -std::expm1(-height * height);
  }
};

}  // namespace reflectance
