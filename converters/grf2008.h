#pragma once

#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

/// Converts a scene to the grammar of 2008 (FORMAT.md lists what it lacks); returns nothing after an error.
/// Names of meshes become comments. Meshes with `none` in their faces are split there. Emitting faces become
/// mesh lights, which have the radiance 1: losses are warnings. Included files stay unchanged: if one would
/// have to change, all are merged into one (`flatten`; `path` is the scene's).
std::optional<grf::Scene> to_grf2008(const grf::Scene& scene, const std::string& path,
                                     grf::Diagnostics& diagnostics);

}  // namespace convert
