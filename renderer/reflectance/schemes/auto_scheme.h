#pragma once

#include "renderer/reflectance/schemes/adaptive_scheme.h"
#include "renderer/reflectance/schemes/own_scheme.h"

namespace reflectance {

/// The BRDF's own closed-form sampler if it is good, else `adaptive` if that is better. `build` measures the
/// standard deviation of the weights f cos / pdf over view angles.
class AutoScheme {
 public:
  static ModelTable<AutoScheme> table() {
    return {
        .keyword = "auto",
        .title = "The better of own and adaptive",
        .description =
            "The default for faces without a `pdf`: the BRDF's own sampler, which needs no precomputation, "
            "if the standard deviation of its weights is below half of their mean; else `adaptive`, if its "
            "weights vary less.",
    };
  }

  static std::string unsupported_reason(const Brdf&) { return {}; }

  void build(const Brdf& brdf);
  std::size_t bytes() const { return is_adaptive_ ? adaptive_.bytes() : 0; }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    return is_adaptive_ ? adaptive_.sample(brdf, u, xi) : OwnScheme().sample(brdf, u, xi);
  }
  float pdf(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const {
    return is_adaptive_ ? adaptive_.pdf(brdf, u, v) : OwnScheme().pdf(brdf, u, v);
  }

  bool is_adaptive() const { return is_adaptive_; }

 private:
  bool is_adaptive_ = false;
  AdaptiveScheme adaptive_;
};

}  // namespace reflectance
