#pragma once

#include "renderer/reflectance/schemes/adaptive_scheme.h"
#include "renderer/reflectance/schemes/own_scheme.h"

namespace reflectance {

/// The BRDF's own closed-form sampler where it is a good one, and else `adaptive`, if that is better. Which
/// one it is, is measured: the deviation of the weights f cos / density over view angles.
class AutoScheme {
 public:
  static ModelTable<AutoScheme> table() {
    return {
        .keyword = "auto",
        .title = "What serves best",
        .about =
            "What a face without a `pdf` has. The BRDF's own sampler, which costs nothing to prepare, where "
            "its weights vary by less than half of their mean; else `adaptive`, if its weights vary less.",
    };
  }

  static std::string refusal(const Brdf&) { return {}; }

  void build(const Brdf& brdf);
  std::size_t bytes() const { return is_adaptive_ ? adaptive_.bytes() : 0; }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    return is_adaptive_ ? adaptive_.sample(brdf, u, xi) : OwnScheme().sample(brdf, u, xi);
  }
  float density(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const {
    return is_adaptive_ ? adaptive_.density(brdf, u, v) : OwnScheme().density(brdf, u, v);
  }

  bool is_adaptive() const { return is_adaptive_; }

 private:
  bool is_adaptive_ = false;
  AdaptiveScheme adaptive_;
};

}  // namespace reflectance
