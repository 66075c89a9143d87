#pragma once

#include <optional>

#include "renderer/reflectance/scheme.h"

namespace reflectance {

struct ScatterSample {
  Vec3f direction;
  Rgb weight;         ///< f cos / density, or the Dirac part's weight over its probability
  float density = 0;  ///< per solid angle; 0 for a mirror direction, which no other technique can draw
  bool is_mirror = false;
};

/// A BRDF with the scheme that samples it: all that a path needs to know of a surface's reflectance. The
/// Dirac part of a BRDF is picked with its own probability, in proportion to its share of the albedo.
class Reflector {
 public:
  Reflector(const Brdf& brdf, const Scheme& scheme) : brdf_(brdf), scheme_(scheme) {}

  /// f(u, v) in 1/sr, without the Dirac part.
  Rgb evaluate(const Vec3f& u, const Vec3f& v) const { return reflectance::evaluate(brdf_, u, v); }

  /// Of `sample`, for a direction that is not the mirror part's.
  float density(const Vec3f& u, const Vec3f& v) const {
    const float share = mirror_share(u);
    return (1 - share) * std::visit([&](const auto& scheme) { return scheme.density(brdf_, u, v); }, scheme_);
  }

  std::optional<ScatterSample> sample(const Vec3f& u, Uniforms xi) const {
    const float share = mirror_share(u);
    if (xi.choice < share) {
      return ScatterSample{mirrored(u), mirror(brdf_, u) / share, 0, true};
    }
    xi.choice = (xi.choice - share) / (1 - share);
    const auto drawn = std::visit([&](const auto& scheme) { return scheme.sample(brdf_, u, xi); }, scheme_);
    if (!drawn) return std::nullopt;
    return ScatterSample{drawn->direction, drawn->weight / (1 - share), drawn->density * (1 - share), false};
  }

  const Brdf& brdf() const { return brdf_; }
  const Scheme& scheme() const { return scheme_; }

  /// True if light that is sampled directly can be reflected at all.
  bool has_density() const { return reflectance::has_density(brdf_); }

 private:
  float mirror_share(const Vec3f& u) const {
    return std::visit(
        [&](const auto& model) {
          const float dirac = mean(mirror_of(model, u));
          return dirac > 0 ? dirac / (dirac + model.albedo_estimate(u)) : 0.0F;
        },
        brdf_);
  }

  Brdf brdf_;
  Scheme scheme_;
};

}  // namespace reflectance
