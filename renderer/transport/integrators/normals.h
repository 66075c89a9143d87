#pragma once

#include "renderer/transport/integrators/kernel.h"

namespace transport {

/// Returns the unit normal at the nearest hit, on the viewer's side, in world space, in place of radiance; 0
/// on the background (BPT_RayCasting of the thesis, section 6.1.3).
Rgb normal_at_hit(const CompiledScene& scene, const IntegratorSettings& settings, const Ray& ray,
                  const std::optional<Rgb>& backplate, PathSampler& sampler, RayCounter& counter);

}  // namespace transport
