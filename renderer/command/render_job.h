#pragma once

#include <optional>

#include "grf/diagnostics.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/bake.h"
#include "renderer/transport/plan/plan.h"
#include "renderer/transport/render.h"

namespace command {

/// What a render will do, before anything costly is made.
struct RenderPlan {
  grf::Scene scene;
  transport::CompileSettings compile_settings;
  transport::RenderSettings settings;  ///< without surroundings
  transport::Plan plan;
};

/// Reads the scene that the options name and looks at what its render calls for; nothing after an error.
std::optional<RenderPlan> render_plan(const options::RenderOptions& render_options,
                                      grf::Diagnostics& diagnostics);

/// What a render needs, once its files have been read.
struct RenderJob {
  transport::CompiledScene scene;
  transport::RenderSettings settings;
  transport::Plan plan;
};

/// Reads and compiles the scene that the options name, with all that they say of it; nothing after an error.
std::optional<RenderJob> render_job(const options::RenderOptions& render_options,
                                    grf::Diagnostics& diagnostics);

/// What a bake needs, once its files have been read.
struct BakeJob {
  grf::Scene scene;  ///< flat
  transport::CompiledScene compiled;
  transport::BakeSettings settings;
  grf::Vec3f eye;  ///< in the world
};

/// The same for a bake, by the integrator `path` whatever the options say.
std::optional<BakeJob> bake_job(options::RenderOptions render_options, int directions,
                                grf::Diagnostics& diagnostics);

}  // namespace command
