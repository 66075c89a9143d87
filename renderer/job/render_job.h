// A render job is made from render options and the scene that they name.
#pragma once

#include <optional>

#include "grf/diagnostics.h"
#include "renderer/bake/bake.h"
#include "renderer/options/render_options.h"
#include "renderer/plan/plan.h"
#include "renderer/transport/render.h"

namespace job {

/// The inputs of a render, with all files read.
struct RenderJob {
  transport::CompiledScene scene;
  transport::RenderSettings settings;
  plan::Plan plan;
};

/// Reads, plans and compiles the scene that the options name; nothing after an error. Some faces may have
/// another sampling scheme than in the scene, unless the options name one for all.
std::optional<RenderJob> render_job(const options::RenderOptions& render_options,
                                    grf::Diagnostics& diagnostics,
                                    const std::optional<transport::SchemeOverride>& scheme = std::nullopt);

/// Checks, plans and compiles a scene that is in memory, whatever scene the options name; nothing after an
/// error. File names in it are absolute.
std::optional<RenderJob> render_job(grf::Scene scene, const options::RenderOptions& render_options,
                                    grf::Diagnostics& diagnostics);

// The steps of `render_job` return nothing, or false, after an error.

/// Reads and checks the scene that the options name.
std::optional<grf::Scene> read_scene(const options::RenderOptions& render_options,
                                     grf::Diagnostics& diagnostics);
/// Reports unknown models, bad values and undefined names.
bool check(const grf::Scene& scene, grf::Diagnostics& diagnostics);
/// Returns the compile settings that the options ask for, before a plan.
std::optional<transport::CompileSettings> compile_settings_of(const options::RenderOptions& render_options,
                                                              grf::Diagnostics& diagnostics);

/// The plan of a render, made before any expensive work.
struct RenderPlan {
  transport::CompileSettings compile_settings;
  transport::RenderSettings settings;
  plan::Plan plan;
};

/// Plans which effects a render of a scene needs. The settings have no environment map or backplate yet.
std::optional<RenderPlan> render_plan(const grf::Scene& scene, transport::CompileSettings compile_settings,
                                      const options::RenderOptions& render_options,
                                      grf::Diagnostics& diagnostics);
/// Loads the environment map or backplate into the settings if the plan needs it, unless it is there already.
bool load_environment(const options::RenderOptions& render_options, RenderPlan& planned,
                      grf::Diagnostics& diagnostics);
/// Returns the settings for a scene of these bounds, without environment map or backplate.
transport::RenderSettings settings_of(const options::RenderOptions& render_options, const grf::Box3d& bounds);
/// Reports an error if the eye and the look-at point coincide.
bool has_view_direction(const transport::View& view, grf::Diagnostics& diagnostics);
/// Loads the environment map or backplate into the settings by the reader of the options, unless it is there
/// already.
bool load_environment(const options::RenderOptions& render_options, transport::RenderSettings& settings,
                      grf::Diagnostics& diagnostics);
/// Loads it likewise by another reader.
bool load_environment(const options::RenderOptions& render_options, transport::RenderSettings& settings,
                      grf::Diagnostics& diagnostics, const image::ImageReader& image_reader);
/// Returns whether the number of samples is limited: not if only a target error or a time limit is given.
bool has_sample_limit(const options::RenderOptions& render_options);
/// Reports an error if the scene has nothing to render.
bool has_geometry(const transport::CompiledScene& scene, const options::RenderOptions& render_options,
                  grf::Diagnostics& diagnostics);

/// The inputs of an irradiance bake, with all files read.
struct BakeJob {
  grf::Scene scene;  ///< flattened
  transport::CompiledScene compiled;
  bake::BakeSettings settings;
  grf::Vec3f eye;  ///< in world coordinates
};

/// Prepares a bake likewise, always with the integrator `path`.
std::optional<BakeJob> bake_job(options::RenderOptions render_options, int directions,
                                grf::Diagnostics& diagnostics);

}  // namespace job
