#pragma once

#include <optional>
#include <vector>

#include "editor/document/object_placement.h"

namespace editor {

/// Applies the transforms of objects to their vertices, normals and lights, so that the objects stay where
/// they are and have no transform. A mirroring transform reverses the corners of faces, whose fronts stay
/// their fronts. Returns nothing, with the reason in the diagnostics, for an object whose transform moves an
/// instance, an included file, an observer or another transform.
std::optional<TransformedObjects> apply_transforms(const grf::Scene& scene,
                                                   const std::vector<grf::ScenePath>& paths,
                                                   grf::Diagnostics& diagnostics);

}  // namespace editor
