#pragma once

#include "renderer/transport/integrators/kernel.h"

namespace transport {

/// What a path kernel can meet. A bit is here only if leaving its code out makes a render faster.
struct PathEffects {
  bool area_lights = true;
  bool environment = true;
  bool resampling = true;
  bool other_than_matte = true;  ///< BRDFs besides `diffuse`, or schemes besides its own
  bool search = false;           ///< for terms that are not finite

  bool operator==(const PathEffects&) const = default;
};

/// An unbiased estimate of the radiance that arrives along a ray: a path that at each surface samples a light
/// and the BRDF, and combines the two by multiple importance sampling (Veach and Guibas 1995, power
/// heuristic). The light is the environment map with a probability of its share of the power, else one of the
/// emitters by the light tree. At the first surface that does more than mirror the path splits in two, and
/// Russian roulette ends paths that carry little. All kernels give the same image where they serve, bit for
/// bit.
///
/// The one that serves these effects and does least besides.
Kernel path_kernel(const PathEffects& effects);

/// The one that serves all effects and notes the first term that is not finite.
Kernel searching_path_kernel();

/// The same, for light that arrives at a point.
GatherKernel gather_kernel(const PathEffects& effects);

}  // namespace transport
