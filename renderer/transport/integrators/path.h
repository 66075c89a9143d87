#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "renderer/reflectance/resampling.h"
#include "renderer/transport/lights/environment_map.h"
#include "renderer/transport/scene/compiled_scene.h"
#include "renderer/transport/sobol.h"

namespace transport {

struct PathSettings {
  Rgb background = Rgb(0);  ///< radiance that comes from where nothing is, W/(sr m2)
  /// In place of the background; null: none.
  std::shared_ptr<const EnvironmentMap> environment;
  /// Has the light of the environment map estimated by resampling at every hit.
  std::optional<reflectance::Resampling> resampling;
  int depth = 5;                   ///< the most scattering events: 0 emission only, 1 direct light only
  bool measures_sampling = false;  ///< fills in RayCounter::sampling_ticks
};

/// What was done for some paths.
struct RayCounter {
  std::uint64_t rays = 0;
  std::uint64_t sampling_ticks = 0;  ///< of `processor_ticks`, spent in sampling schemes to draw directions
};

/// An unbiased estimate of the radiance that arrives along a ray: a path that at each surface samples a light
/// and the BRDF, and combines the two by multiple importance sampling (Veach and Guibas 1995, power
/// heuristic). The light is the environment map with a probability of 1/2, if it is not black and there are
/// emitters too, else one of the emitters by the light tree.
///
/// `behind` is what the ray itself sees if it meets nothing, in place of what lights the scene.
Rgb path_radiance(const CompiledScene& scene, const PathSettings& settings, const Ray& ray,
                  const std::optional<Rgb>& behind, PathNumbers& numbers, RayCounter& counter);

}  // namespace transport
