#pragma once

#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

/// The scene in what the grammar of 2008 can say (FORMAT.md lists what it lacks), or nothing after an error.
/// Names of meshes become comments. Meshes whose faces return to having no colour, BRDF, PDF or texture are
/// cut there into several. Emitting faces become mesh lights, which have the radiance 1: what is lost is a
/// warning. Included files stay as they are: if one would have to change, all become one (`flatten`; `path`
/// is the scene's).
std::optional<grf::Scene> to_grf2008(const grf::Scene& scene, const std::string& path,
                                     grf::Diagnostics& diagnostics);

}  // namespace convert
