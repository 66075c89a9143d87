#include "renderer/transport/integrators/normals.h"

namespace transport {

Rgb normal_at_hit(const CompiledScene& scene, const IntegratorSettings&, const Ray& ray,
                  const std::optional<Rgb>&, PathSampler& sampler, RayCounter& counter) {
  ++counter.rays;
  const auto point = scene.intersect(ray, sampler.word());
  if (!point) return Rgb(0);
  return ray.direction.dot(point->geometric_normal) > 0 ? -point->shading_normal : point->shading_normal;
}

}  // namespace transport
