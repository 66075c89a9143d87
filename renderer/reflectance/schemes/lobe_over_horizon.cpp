#include "renderer/reflectance/schemes/lobe_over_horizon.h"

#include <numbers>

namespace reflectance {

LobeOverHorizon::LobeOverHorizon(double n) {
  constexpr double Deviations = 8;  // beyond this a narrow lobe is 0
  const double end = std::min(std::numbers::pi / 2, Deviations / std::sqrt(n + 1));
  const double step = end / Steps;
  const auto power = [&](double angle) {
    const double sine = std::sin(angle / 2);
    return std::exp(n * std::log1p(-2 * sine * sine));  // the cosine itself lacks the digits for a large n
  };
  // Integrates by Simpson's rule.
  std::array<double, Steps + 1> integrals = {};
  for (int i = 0; i < Steps; ++i) {
    const double of_step = power(i * step) + 4 * power((i + 0.5) * step) + power((i + 1) * step);
    integrals[i + 1] = integrals[i] + of_step;
  }
  for (int i = 0; i <= Steps; ++i) {
    shares_[i] = static_cast<float>((1 + integrals[i] / integrals[Steps]) / 2);
  }
  steps_per_radian_ = static_cast<float>(Steps / end);
}

}  // namespace reflectance
