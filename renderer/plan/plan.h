// A plan says which effects, tables and textures a scene, its view and its render options need, and why.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "renderer/plan/reachability.h"
#include "renderer/transport/render.h"

namespace plan {

/// The facts that a plan is based on, known before anything expensive is built.
struct PlanSettings {
  PathLimits limits;
  bool draws_normals = false;  ///< only: Integrator::Normals
  bool has_environment = false;
  bool has_backplate = false;
  bool has_background = false;  ///< that is not black
  bool uses_irradiance = false;
  bool shows_surfaces = false;  ///< feature layers: visible surfaces are needed whatever the depth
  std::string scheme;           ///< replaces the schemes of all BRDFs; empty: the scene's own
  bool keeps_all = false;       ///< leaves out only what is switched off
};

/// A surface of a mesh, or an area light, of the scene that was planned.
struct SurfacePlace {
  const grf::Mesh* mesh = nullptr;  ///< null: an area light
  std::uint32_t index = 0;          ///< in the mesh's list of surfaces; of a light, as in CoarseSurface

  bool operator==(const SurfacePlace&) const = default;
};

struct PlannedEffect {
  transport::Effect effect;
  bool is_needed = false;
  std::string why;  ///< a sentence without its full stop
  /// The surfaces that call for it; none if the view, the options or the geometry do.
  std::vector<SurfacePlace> places = {};
};

/// A pair of BRDF and sampling scheme that may need a table.
struct PlannedTable {
  std::string brdf, scheme;  ///< as written in the scene
  std::string identity;      ///< identifies the BRDF as resolved in its scope, see CoarseSurface
  bool is_needed = false;
  std::string why;  ///< if it is not needed
};

struct PlannedTexture {
  std::string file;
  bool is_needed = false;
  std::string why;
};

struct Plan {
  std::vector<PlannedEffect> effects;  ///< in the order of EffectInfos
  std::vector<PlannedTable> tables;
  std::vector<PlannedTexture> textures;
  int asked_depth = 0;
  int depth = 0;  ///< the maximum number of bounces
  std::string why_depth;
  std::shared_ptr<const transport::ReflectingSurfaces> reflecting;  ///< null: all

  transport::EffectSet needed() const;
  const PlannedEffect& operator[](transport::Effect effect) const {
    return effects[static_cast<std::size_t>(effect)];
  }
};

Plan plan_of(const CoarseScene& coarse_scene, const PlanSettings& settings);

/// Removes from the settings what the plan does not need.
void follow(const Plan& plan, transport::RenderSettings& settings);

/// Removes from the settings what serves only other effects.
void keep_only(const transport::EffectSet& effects, transport::RenderSettings& settings);

}  // namespace plan
