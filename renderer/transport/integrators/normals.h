#pragma once

#include "renderer/transport/integrators/kernel.h"

namespace transport {

/// Not light but the components of the unit normal at the nearest hit, on the viewer's side, in world space;
/// 0 where nothing is (BPT_RayCasting of the thesis, section 6.1.3).
Rgb normal_at_hit(const CompiledScene& scene, const IntegratorSettings& settings, const Ray& ray,
                  const std::optional<Rgb>& behind, PathNumbers& numbers, RayCounter& counter);

}  // namespace transport
