#include "renderer/transport/integrators/kernel.h"

#include <algorithm>

#include "renderer/transport/integrators/naive.h"
#include "renderer/transport/integrators/normals.h"
#include "renderer/transport/integrators/path.h"

namespace transport {
namespace {

PathEffects path_effects(const CompiledScene& scene, const IntegratorSettings& settings) {
  if (settings.uses_full_kernel) return {};
  PathEffects effects;
  effects.area_lights = !scene.lights().empty();
  effects.environment = settings.environment != nullptr;
  effects.resampling = settings.environment && settings.resampling;
  effects.needs_general_bsdf = settings.measures_sampling || !scene.is_diffuse();
  effects.transmission = scene.has_glass();
  effects.varying_brdfs = scene.has_varying_brdfs();
  return effects;
}

}  // namespace

Kernel kernel_of(const CompiledScene& scene, const IntegratorSettings& settings) {
  switch (settings.integrator) {
    case Integrator::Naive:
      return naive_radiance;
    case Integrator::Normals:
      return normal_at_hit;
    case Integrator::Path:
      break;
  }
  return path_kernel(path_effects(scene, settings));
}

Kernel observing_kernel_of(const CompiledScene& scene, const IntegratorSettings& settings) {
  if (settings.integrator != Integrator::Path) return kernel_of(scene, settings);
  return observing_path_kernel();
}

GatherKernel gather_kernel_of(const CompiledScene& scene, const IntegratorSettings& settings) {
  return gather_kernel(path_effects(scene, settings));
}

}  // namespace transport
