// Assimp's scenes are converted to GRF. Only this folder depends on Assimp.
#pragma once

#include <optional>
#include <string>

#include <assimp/scene.h>

#include "converters/assimp/assimp_rules.h"
#include "converters/format.h"
#include "converters/losses.h"
#include "grf/diagnostics.h"

namespace convert {

/// Converts nodes with faces to transforms, and their faces to meshes; meshes of several nodes become a
/// definition and instances. Returns nothing after an error: an index out of range, a number that is not
/// finite, a file without faces. `losses` are those known so far, which are reported with the others.
std::optional<Import> make_scene(const aiScene& imported, const AssimpRules& rules, Losses losses,
                                 const grf::SourceLocation& location, grf::Diagnostics& diagnostics);

}  // namespace convert
