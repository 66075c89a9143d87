#pragma once

#include "renderer/transport/integrators/kernel.h"

namespace transport {

/// The estimator of the thesis (sections 4.1 and 6.1): at the first hit, the BRDF's scheme draws
/// `secondary_rays` directions, each continues as one path up to `depth`, and lights are only hit by chance:
/// there is no light sampling. For studies of sampling schemes.
Rgb naive_radiance(const CompiledScene& scene, const IntegratorSettings& settings, const Ray& ray,
                   const std::optional<Rgb>& backplate, PathSampler& sampler, RayCounter& counter);

}  // namespace transport
