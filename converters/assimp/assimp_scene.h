// Scenes of Assimp's as scenes of GRF. With the reader of OBJ, whose scenes are of another kind, this folder
// is all that knows Assimp.
#pragma once

#include <optional>
#include <string>

#include <assimp/scene.h>

#include "converters/assimp/assimp_rules.h"
#include "converters/format.h"
#include "converters/losses.h"
#include "grf/diagnostics.h"

namespace convert {

/// The nodes that have faces as transforms, their faces as meshes: what several nodes place is defined once
/// and used. Nothing after an error: an index that points nowhere, a number that is none, a file without
/// faces. `losses` are those known so far, which are reported with what the scene cannot hold of the rest.
std::optional<Import> make_scene(const aiScene& imported, const AssimpRules& rules, Losses losses,
                                 const grf::SourceLocation& location, grf::Diagnostics& diagnostics);

}  // namespace convert
