#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "renderer/reflectance/resampling.h"
#include "renderer/transport/lights/environment_map.h"
#include "renderer/transport/scene/compiled_scene.h"
#include "renderer/transport/sobol.h"

namespace transport {

class ShadingPoint;

enum class Integrator { Path, Naive, Normals };

/// Settings of an integrator.
struct IntegratorSettings {
  Integrator integrator = Integrator::Path;
  Rgb background = Rgb(0);  ///< background radiance, W/(sr m2)
  /// Environment map in place of the background; null: none.
  std::shared_ptr<const EnvironmentMap> environment;
  /// Estimates the environment map's light by resampling at every hit. `Path` only.
  std::optional<reflectance::Resampling> resampling;
  int depth = 5;  ///< maximum number of bounces: 0 emission only, 1 direct light only
  /// A factor of the light that reaches the eye after `depth` bounces; `Path` only. See Truncation.
  Rgb last_bounce_factor = Rgb(1);
  int secondary_rays = 100;  ///< per first hit; `Naive` only
  /// Split count: the number of paths that continue from the first hit on a non-specular surface, if more
  /// than direct light may follow; `Path` only. Indirect light varies more than direct light, and splitting
  /// saves the camera ray: 2 pays under lamps, and more does not pay under an environment map. `bpt cost`
  /// shows the efficiency of a scene whose OP file sets BPT_Branches.
  int split_count = 2;
  /// Uses baked irradiance, if the scene was compiled with it, for all light at a path's first hit, directly
  /// or via specular reflection, on the front of a surface without glossy and specular parts; the path ends
  /// there. `Path` only.
  bool uses_irradiance = false;
  bool reflects_specular = true;   ///< else the delta part of BRDFs reflects nothing
  bool uses_full_kernel = false;   ///< the kernel with all effects, whatever the scene needs; `Path` only
  bool measures_sampling = false;  ///< fills RayCounter::sampling_ticks
};

/// The first term of a path that is not finite.
struct NotFinite {
  std::string_view term;              ///< such as `BRDF's value`; empty: none is
  std::optional<SurfacePoint> where;  ///< empty for radiance from outside the scene
};

/// What one light adds to the radiance that a path estimates.
struct Contribution {
  Rgb radiance = Rgb(0);
  /// The emitter; InvalidIndex for the environment, the background and baked irradiance.
  std::uint32_t emitter = InvalidIndex;
  /// The reflector at which light from there was reflected first, on its way to the eye; InvalidIndex if the
  /// eye sees the light itself.
  std::uint32_t reflector = InvalidIndex;
  int bounces = 0;  ///< between the light and the eye
};

/// Counters of the work for some paths, and what an observing kernel stores besides.
struct RayCounter {
  std::uint64_t rays = 0;
  std::uint64_t sampling_ticks = 0;  ///< in `processor_ticks`, spent in sampling schemes to draw directions
  NotFinite* not_finite = nullptr;   ///< where an observing kernel stores the first non-finite term
  /// Where an observing kernel appends what the radiance of a path consists of; they sum to it.
  std::vector<Contribution>* contributions = nullptr;

  template <class Value>
  void check_finite(std::string_view term, const Value& value, const SurfacePoint* where) const;
};

/// Estimates the radiance that arrives along a ray. `backplate` is the backplate's value, which a camera ray
/// that hits nothing returns instead of the environment.
using Kernel = Rgb (*)(const CompiledScene& scene, const IntegratorSettings& settings, const Ray& ray,
                       const std::optional<Rgb>& backplate, PathSampler& sampler, RayCounter& counter);

/// Returns the integrator's cheapest kernel that supports the scene's effects.
Kernel kernel_of(const CompiledScene& scene, const IntegratorSettings& settings);

/// Returns a slower kernel with the same result that also looks for terms that are not finite, and, for the
/// integrator `Path`, lists contributions.
Kernel observing_kernel_of(const CompiledScene& scene, const IntegratorSettings& settings);

/// Incident radiance from a unit direction, in the coordinates of the compiled scene; the direction is
/// (0,0,0) without radiance.
struct IncidentSample {
  Vec3f direction = Vec3f(0);
  Rgb radiance = Rgb(0);
};

/// An estimate of the radiance that a white diffuse surface reflects, in its two parts: from light sampling
/// and from cosine-weighted direction sampling. Pi times their sum estimates the irradiance.
struct GatherSample {
  IncidentSample light, scattered;
};

/// Estimates the incident radiance at a point whose reflector and colour are white and diffuse. This is the
/// path's first bounce of `depth`, which must be at least 1; nothing is resampled.
using GatherKernel = GatherSample (*)(const CompiledScene& scene, const IntegratorSettings& settings,
                                      const ShadingPoint& shading, PathSampler& sampler, RayCounter& counter);

/// Returns the path integrator's cheapest kernel that supports the scene's effects.
GatherKernel gather_kernel_of(const CompiledScene& scene, const IntegratorSettings& settings);

inline bool is_finite(float value) { return std::isfinite(value); }
inline bool is_finite(const Rgb& value) {
  return is_finite(value.x) && is_finite(value.y) && is_finite(value.z);
}

template <class Value>
void RayCounter::check_finite(std::string_view term, const Value& value, const SurfacePoint* where) const {
  if (not_finite == nullptr || !not_finite->term.empty() || is_finite(value)) return;
  not_finite->term = term;
  if (where != nullptr) not_finite->where = *where;
}

}  // namespace transport
