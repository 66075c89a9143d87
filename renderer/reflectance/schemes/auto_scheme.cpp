#include "renderer/reflectance/schemes/auto_scheme.h"

#include <array>
#include <cmath>

#include "renderer/reflectance/halton.h"

namespace reflectance {
namespace {

/// The second moments of the weights over their squared mean, for the BRDF's own sampler and for `adaptive`.
struct Moments {
  double own = 1;
  double adaptive = 1;
};

/// Measures both from the own sampler's samples: the other's second moment is the mean product of weights.
Moments moments_at(const Brdf& brdf, const Vec3f& u, const AdaptiveScheme* adaptive) {
  constexpr std::uint32_t Samples = 1024;
  double sum = 0;
  double own = 0;
  double other = 0;
  for (std::uint32_t i = 0; i < Samples; ++i) {
    const auto drawn = OwnScheme().sample(brdf, u, halton_point(i));
    const double weight = drawn ? mean(drawn->weight) : 0.0;
    if (!(weight > 0)) continue;
    sum += weight;
    own += weight * weight;
    if (adaptive == nullptr) continue;
    const double pdf = adaptive->pdf(brdf, u, drawn->direction);
    other += pdf > 0 ? weight * weight * drawn->pdf / pdf : HUGE_VAL;
  }
  if (!(sum > 0)) return {};
  return {own * Samples / (sum * sum), other * Samples / (sum * sum)};
}

Moments mean_moments(const Brdf& brdf, const AdaptiveScheme* adaptive) {
  constexpr std::array<float, 4> Degrees = {5, 30, 55, 75};
  constexpr std::array<float, 2> Azimuths = {0.2F, 1.3F};
  Moments sum = {0, 0};
  for (const float degrees : Degrees) {
    for (const float phi : Azimuths) {
      const float theta = degrees * Pi / 180;
      const Moments one = moments_at(brdf, from_angles(std::cos(theta), std::sin(theta), phi), adaptive);
      sum.own += one.own / (Degrees.size() * Azimuths.size());
      sum.adaptive += one.adaptive / (Degrees.size() * Azimuths.size());
    }
  }
  return sum;
}

}  // namespace

void AutoScheme::build(const Brdf& brdf) {
  constexpr double GoodVariance = 0.25;
  is_adaptive_ = false;
  if (!has_nonspecular_part(brdf) || mean_moments(brdf, nullptr).own < 1 + GoodVariance) return;
  adaptive_.build(brdf);
  const Moments moments = mean_moments(brdf, &adaptive_);
  is_adaptive_ = moments.adaptive < moments.own;
  if (!is_adaptive_) adaptive_ = {};
}

}  // namespace reflectance
