#pragma once

#include "renderer/transport/integrators/kernel.h"

namespace transport {

/// Effects that a path kernel supports. A bit is here only if omitting its code makes a render faster.
struct PathEffects {
  bool area_lights = true;
  bool environment = true;
  bool resampling = true;
  bool needs_general_bsdf = true;  ///< BRDFs besides `diffuse`, or sampling schemes besides its own
  bool transmission = true;        ///< glass
  bool varying_brdfs = true;       ///< images vary BRDFs over faces
  bool observe = false;            ///< looks for terms that are not finite, and lists contributions

  bool operator==(const PathEffects&) const = default;

  /// Returns whether a kernel with these effects serves where others are wanted.
  bool cover(const PathEffects& wanted) const {
    return area_lights >= wanted.area_lights && environment >= wanted.environment &&
           resampling >= wanted.resampling && needs_general_bsdf >= wanted.needs_general_bsdf &&
           transmission >= wanted.transmission && varying_brdfs >= wanted.varying_brdfs;
  }
};

/// Returns the cheapest path-tracing kernel that supports these effects. It estimates the radiance along a
/// ray without bias: at each hit the path samples a light (next-event estimation) and the BRDF, combined by
/// multiple importance sampling (Veach and Guibas 1995, power heuristic). It samples the environment map with
/// a probability that follows its fraction of the power, else an emitter by the light tree. At the first
/// non-specular hit the path splits in two, and Russian roulette ends paths of low throughput. All kernels
/// that support a scene give the same image, bit for bit.
Kernel path_kernel(const PathEffects& effects);

/// Returns the kernel that supports all effects, reports the first term that is not finite, and lists
/// contributions.
Kernel observing_path_kernel();

/// Returns the corresponding kernel for light that arrives at a point.
GatherKernel gather_kernel(const PathEffects& effects);

}  // namespace transport
