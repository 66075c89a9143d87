#pragma once

#include <memory>

#include "renderer/reflectance/cosine_lobe.h"
#include "renderer/reflectance/schemes/lobe_exponent.h"
#include "renderer/reflectance/schemes/lobe_over_horizon.h"
#include "renderer/reflectance/schemes/split_mix.h"
#include "renderer/reflectance/schemes/weighted.h"

namespace reflectance {

/// Samples a cosine lobe about the mirror direction, cut at the horizon: a direction below it is drawn again.
struct HemisphereScheme {
  static constexpr bool IsIncomplete = true;

  float exponent = OwnExponent;

  static ModelTable<HemisphereScheme> table() {
    return {
        .keyword = "hemisphere",
        .title = "Cosine lobe on the hemisphere",
        .paper = "Arvo 1995",
        .parameters = {number_parameter(&HemisphereScheme::exponent, "exp", OwnExponent, 1e6F,
                                        "exponent of the lobe; below 0: the BRDF's own, or 10 if it has none",
                                        grf::ParameterScale::Logarithmic)},
        .description =
            "Samples a cosine lobe about the mirror direction, for BRDFs with such a lobe. A direction below "
            "the horizon is drawn again, so that no sample is lost."};
  }

  static std::string unsupported_reason(const Brdf&) { return {}; }

  void build(const Brdf& brdf) {
    n_ = exponent >= 0 ? exponent : own_exponents(brdf).about_mirror();
    over_horizon_ = std::make_shared<const LobeOverHorizon>(n_);
  }
  std::size_t bytes() const { return over_horizon_ ? sizeof(LobeOverHorizon) : 0; }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    constexpr int MostTries = 64;  // each try succeeds with a probability of at least 1/2
    if (!(u.z > 0)) return std::nullopt;
    Vec3f v = cosine_lobe_direction(u, n_, xi.direction);
    SplitMix more(xi);
    for (int tries = 1; !(v.z > 0) && tries < MostTries; ++tries) {
      v = cosine_lobe_direction(u, n_, more.next_pair());
    }
    return weighted(brdf, u, v, pdf(brdf, u, v));
  }
  float pdf(const Brdf&, const Vec3f& u, const Vec3f& v) const {
    if (!(u.z > 0 && v.z > 0) || !over_horizon_) return 0;
    return cosine_lobe_pdf(u, v, n_) / over_horizon_->fraction(u.z);
  }

 private:
  float n_ = PlainExponents.about_mirror();
  std::shared_ptr<const LobeOverHorizon> over_horizon_;
};

}  // namespace reflectance
