#pragma once

#include "renderer/transport/integrators/kernel.h"

namespace transport {

/// The estimator of the thesis (sections 4.1 and 6.1): at the first hit `secondary_rays` directions are drawn
/// by the BRDF's scheme, each goes on as one path to `depth`, and all light is what paths happen to meet: no
/// light is sampled. For studies of sampling schemes.
Rgb naive_radiance(const CompiledScene& scene, const IntegratorSettings& settings, const Ray& ray,
                   const std::optional<Rgb>& behind, PathNumbers& numbers, RayCounter& counter);

}  // namespace transport
