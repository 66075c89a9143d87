// What the options of a render and a scene come to: all that rays need.
#pragma once

#include <optional>

#include "grf/diagnostics.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/bake.h"
#include "renderer/transport/plan/plan.h"
#include "renderer/transport/render.h"

namespace job {

/// What a render needs, once its files have been read.
struct RenderJob {
  transport::CompiledScene scene;
  transport::RenderSettings settings;
  transport::Plan plan;
};

/// Reads and compiles the scene that the options name, with all that they say of it; nothing after an error.
std::optional<RenderJob> render_job(const options::RenderOptions& render_options,
                                    grf::Diagnostics& diagnostics);

// The parts of which `render_job` is made; nothing, or false, after an error.

/// The scene as its author wrote it, checked.
std::optional<grf::Scene> read_scene(const options::RenderOptions& render_options,
                                     grf::Diagnostics& diagnostics);
/// An error unless its models are known and right, and its names mean something.
bool check(const grf::Scene& scene, grf::Diagnostics& diagnostics);
/// What the options say of compiling, before a plan.
std::optional<transport::CompileSettings> compile_settings_of(const options::RenderOptions& render_options,
                                                              grf::Diagnostics& diagnostics);

/// What a render will do, before anything costly is made.
struct RenderPlan {
  transport::CompileSettings compile_settings;
  transport::RenderSettings settings;
  transport::Plan plan;
};

/// Looks at what a render of a scene calls for. Its settings are without surroundings.
std::optional<RenderPlan> render_plan(const grf::Scene& scene, transport::CompileSettings compile_settings,
                                      const options::RenderOptions& render_options,
                                      grf::Diagnostics& diagnostics);
/// Reads the image around or behind the scene into the settings, if the plan needs it; what is there already
/// is kept.
bool load_surroundings(const options::RenderOptions& render_options, RenderPlan& planned,
                       grf::Diagnostics& diagnostics);
/// What the options say of a render of what is in this box, without surroundings.
transport::RenderSettings settings_of(const options::RenderOptions& render_options, const grf::Box3d& bounds);
/// An error if the eye is where it looks at.
bool has_direction(const transport::View& view, grf::Diagnostics& diagnostics);
/// Reads the image around or behind the scene into the settings; what is there already is kept.
bool load_surroundings(const options::RenderOptions& render_options, transport::RenderSettings& settings,
                       grf::Diagnostics& diagnostics,
                       const transport::ImageReader& image_reader = transport::read_image);
/// Whether samples are counted: time and error decide how many there are, unless their number was given.
bool counts_samples(const options::RenderOptions& render_options);
/// An error if there is nothing to render.
bool has_something(const transport::CompiledScene& scene, const options::RenderOptions& render_options,
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

}  // namespace job
