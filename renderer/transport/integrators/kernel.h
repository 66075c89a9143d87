#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "renderer/reflectance/resampling.h"
#include "renderer/transport/lights/environment_map.h"
#include "renderer/transport/scene/compiled_scene.h"
#include "renderer/transport/sobol.h"

namespace transport {

class Scattering;

enum class Integrator { Path, Naive, Normals };

/// What an integrator is told besides the scene.
struct IntegratorSettings {
  Integrator integrator = Integrator::Path;
  Rgb background = Rgb(0);  ///< radiance that comes from where nothing is, W/(sr m2)
  /// In place of the background; null: none.
  std::shared_ptr<const EnvironmentMap> environment;
  /// Has the light of the environment map estimated by resampling at every hit. Of `Path` alone.
  std::optional<reflectance::Resampling> resampling;
  int depth = 5;             ///< the most scattering events: 0 emission only, 1 direct light only
  int secondary_rays = 100;  ///< for each first hit; of `Naive` alone
  /// In how many directions a path goes on from its first hit that does more than mirror, if it may go
  /// further than to a light; of `Path` alone. What comes by way of other surfaces varies more than what
  /// comes from lights directly, and costs no camera ray again: 2 pay under lamps, and more do not pay under
  /// an environment map. `bpt cost` shows the efficiency of a scene whose OP file sets BPT_Branches.
  int branches = 2;
  /// Takes the irradiance that the scene was compiled with for all light at a path's first hit, directly or
  /// by mirrors, if that is on the front of a surface with neither a glossy nor a mirror part; the path ends
  /// there. Of `Path` alone.
  bool uses_irradiance = false;
  bool reflects_mirrors = true;    ///< else the Dirac part of BRDFs reflects nothing
  bool uses_full_kernel = false;   ///< of `Path` alone: that which does all, whatever the scene calls for
  bool measures_sampling = false;  ///< fills in RayCounter::sampling_ticks
};

/// The first term of a path that is not finite.
struct NotFinite {
  std::string_view term;              ///< `BRDF's value`; empty: none is
  std::optional<SurfacePoint> where;  ///< nothing for what comes from outside the scene
};

/// What was done for some paths.
struct RayCounter {
  std::uint64_t rays = 0;
  std::uint64_t sampling_ticks = 0;  ///< of `processor_ticks`, spent in sampling schemes to draw directions
  NotFinite* not_finite = nullptr;   ///< where a kernel that looks for such a term notes it

  template <class Value>
  void note_unless_finite(std::string_view term, const Value& value, const SurfacePoint* where) const;
};

/// Estimates the radiance that arrives along a ray. `behind` is what the ray itself sees if it meets nothing,
/// in place of what lights the scene.
using Kernel = Rgb (*)(const CompiledScene& scene, const IntegratorSettings& settings, const Ray& ray,
                       const std::optional<Rgb>& behind, PathNumbers& numbers, RayCounter& counter);

/// The kernel of the integrator that does least besides what the scene's effects call for.
Kernel kernel_of(const CompiledScene& scene, const IntegratorSettings& settings);

/// The kernel that gives the same and looks for terms that are not finite, in more time.
Kernel searching_kernel_of(const CompiledScene& scene, const IntegratorSettings& settings);

/// What arrives from a direction, unit, in the coordinates of the compiled scene; (0,0,0) with nothing.
struct Arrival {
  Vec3f direction = Vec3f(0);
  Rgb radiance = Rgb(0);
};

/// An estimate of the radiance that a white matte surface reflects, in its two parts: the light that was
/// sampled, and what comes along the direction that was drawn by cosine. Times pi, their sum is one of the
/// irradiance.
struct Gathered {
  Arrival light, scattered;
};

/// Estimates what arrives at a point whose reflector and colour are white and matte. The scattering there is
/// the path's first of `depth`, of which there must be one; nothing is resampled.
using GatherKernel = Gathered (*)(const CompiledScene& scene, const IntegratorSettings& settings,
                                  const Scattering& scattering, PathNumbers& numbers, RayCounter& counter);

/// That of the integrator `path` that does least besides what the scene's effects call for.
GatherKernel gather_kernel_of(const CompiledScene& scene, const IntegratorSettings& settings);

inline bool is_finite(float value) { return std::isfinite(value); }
inline bool is_finite(const Rgb& value) {
  return is_finite(value.x) && is_finite(value.y) && is_finite(value.z);
}

template <class Value>
void RayCounter::note_unless_finite(std::string_view term, const Value& value,
                                    const SurfacePoint* where) const {
  if (not_finite == nullptr || !not_finite->term.empty() || is_finite(value)) return;
  not_finite->term = term;
  if (where != nullptr) not_finite->where = *where;
}

}  // namespace transport
