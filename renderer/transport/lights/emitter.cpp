#include "renderer/transport/lights/emitter.h"

#include <algorithm>
#include <cmath>

#include "renderer/transport/scene/ray_offset.h"

namespace transport {

Emitters::Emitters(std::vector<Emitter> emitters) : emitters_(std::move(emitters)) {
  // What has no area or radiates nothing lights nothing, and would make a probability 0/0.
  std::vector<double> powers;
  double total = 0;
  for (const Emitter& emitter : emitters_) {
    area_.push_back(emitter.area());
    powers.push_back(static_cast<double>(area_.back()) * reflectance::mean(emitter.radiance));
    total += powers.back();
  }
  double sum = 0;
  for (const double power : powers) {
    sum += power;
    probability_.push_back(static_cast<float>(power / total));
    cumulative_.push_back(static_cast<float>(sum / total));
  }
}

LightSample Emitters::sample(float choice, const Vec2f& xi) const {
  const auto above = std::upper_bound(cumulative_.begin(), cumulative_.end(), choice);
  const auto index = static_cast<std::size_t>(
      std::min<std::ptrdiff_t>(above - cumulative_.begin(), static_cast<std::ptrdiff_t>(size()) - 1));
  const Emitter& emitter = emitters_[index];
  Vec2f point = xi;
  if (emitter.is_triangle) {
    const float root = std::sqrt(xi.x);
    point = {1 - root, root * xi.y};
  }
  const Vec3f extent = absolute(emitter.corner) + absolute(emitter.edge1) + absolute(emitter.edge2);
  return {emitter.corner + emitter.edge1 * point.x + emitter.edge2 * point.y,
          extent * InterpolationError,
          emitter.doubled_area_normal().normalized(),
          emitter.radiance,
          area_density(index),
          static_cast<std::uint32_t>(index)};
}

}  // namespace transport
