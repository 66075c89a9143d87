// What a scene, its view and the options of its render call for, and why.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "renderer/transport/plan/reach.h"
#include "renderer/transport/render.h"

namespace transport {

/// What is known of a render before anything costly is made.
struct PlanSettings {
  PathLimits limits;
  bool draws_normals = false;  ///< and nothing else: Integrator::Normals
  bool has_environment = false;
  bool has_backplate = false;
  bool has_background = false;  ///< one that is not black
  bool uses_irradiance = false;
  bool shows_surfaces = false;  ///< feature layers: what the eye sees is needed whatever the depth
  std::string scheme;           ///< of all BRDFs, in place of the scene's; empty: those
  bool keeps_all = false;       ///< leaves nothing out but what is switched off
};

struct PlannedEffect {
  Effect effect;
  bool is_needed = false;
  std::string why;  ///< a sentence without its stop
};

/// A pair of BRDF and scheme for which a table may be made.
struct PlannedTable {
  std::string brdf, scheme;  ///< as a scene writes them
  std::string identity;      ///< what the BRDF's text means where it stands, see OutlineSurface
  bool is_needed = false;
  std::string why;  ///< if it is not
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
  int depth = 0;  ///< the most scattering events that paths have
  std::string why_depth;
  std::shared_ptr<const ReflectingSurfaces> reflecting;  ///< null: all

  EffectSet needed() const;
  const PlannedEffect& operator[](Effect effect) const { return effects[static_cast<std::size_t>(effect)]; }
};

Plan plan_of(const Outline& outline, const PlanSettings& settings);

/// Leaves out of the settings what the plan leaves out.
void follow(const Plan& plan, RenderSettings& settings);

/// Leaves out of the settings what serves other effects alone.
void keep_only(const EffectSet& effects, RenderSettings& settings);

}  // namespace transport
