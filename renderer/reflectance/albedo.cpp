#include "renderer/reflectance/albedo.h"

#include <algorithm>
#include <cmath>

namespace reflectance {

Uniforms even_point(std::uint32_t index) {
  constexpr double Root = 1.2207440846057594754;
  const auto coordinate = [&](double step) {
    const double sum = 0.5 + step * index;
    return std::min(static_cast<float>(sum - std::floor(sum)), 0x1.fffffep-1F);
  };
  return {{coordinate(1 / Root), coordinate(1 / (Root * Root))}, coordinate(1 / (Root * Root * Root))};
}

Rgb albedo(const Reflector& reflector, const Vec3f& u, int count) {
  Imath::V3d sum(0);
  for (int i = 0; i < count; ++i) {
    const auto drawn = reflector.sample(u, even_point(static_cast<std::uint32_t>(i)));
    if (drawn) sum += Imath::V3d(drawn->weight);
  }
  return Rgb(sum / count);
}

}  // namespace reflectance
