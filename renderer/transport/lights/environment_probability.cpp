#include "renderer/transport/lights/environment_probability.h"

#include <algorithm>
#include <numbers>

namespace transport {

float environment_probability(const EnvironmentMap* environment, const Lights& lights,
                              const grf::Box3d& bounds) {
  if (environment == nullptr || environment->is_black()) return 0;
  if (lights.empty()) return 1;
  constexpr double Least = 0.2;
  const double diameter2 = bounds.isEmpty() ? 0 : double((bounds.max - bounds.min).length2());
  const double outside = std::numbers::pi * diameter2 / 4 * environment->total();
  const double inside = lights.power();
  if (!(outside + inside > 0)) return 0.5F;
  return static_cast<float>(std::clamp(outside / (outside + inside), Least, 1 - Least));
}

}  // namespace transport
