#pragma once

#include <optional>

#include "grf/diagnostics.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/bake.h"
#include "renderer/transport/render.h"

namespace command {

/// What a render needs, once its files have been read.
struct RenderJob {
  transport::CompiledScene scene;
  transport::RenderSettings settings;
};

// The parts of which `render_job` is made; nothing after an error.

/// The scene as its author wrote it, checked.
std::optional<grf::Scene> read_scene(const options::RenderOptions& render_options,
                                     grf::Diagnostics& diagnostics);
/// What the options say of compiling.
std::optional<transport::CompileSettings> compile_settings_of(const options::RenderOptions& render_options,
                                                              grf::Diagnostics& diagnostics);
/// All else that they say, of a scene in that box. Reads the image around or behind it.
std::optional<transport::RenderSettings> render_settings_of(const options::RenderOptions& render_options,
                                                            const grf::Box3d& bounds,
                                                            grf::Diagnostics& diagnostics);

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
