#pragma once

#include <cstdint>

#include "renderer/transport/compiled_scene.h"
#include "renderer/transport/sobol.h"

namespace transport {

struct PathSettings {
  Rgb background = Rgb(0);  ///< radiance that comes from where nothing is, W/(sr m2)
  int depth = 5;            ///< the most scattering events: 0 emission only, 1 direct light only
};

struct RayCounter {
  std::uint64_t rays = 0;
};

/// An unbiased estimate of the radiance that arrives along a ray: a path that at each surface samples a light
/// and the BRDF, and combines the two by multiple importance sampling (Veach and Guibas 1995, power
/// heuristic).
Rgb path_radiance(const CompiledScene& scene, const PathSettings& settings, const Ray& ray,
                  PathNumbers& numbers, RayCounter& counter);

}  // namespace transport
