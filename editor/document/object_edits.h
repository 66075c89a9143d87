// Edits objects of a scene: duplicate, rename and delete. Each edit returns a new scene, or nothing
// with the reason in the diagnostics.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/document/scene_objects.h"
#include "grf/diagnostics.h"
#include "grf/math.h"
#include "grf/scene.h"
#include "grf/scene_path.h"

namespace editor {

/// Deletes blocks, definitions without other references, and observers, whose `params` is deleted with the
/// last of them.
std::optional<grf::Scene> remove_objects(const grf::Scene& scene, const std::vector<grf::ScenePath>& paths,
                                         const std::vector<ObserverObject>& observers,
                                         grf::Diagnostics& diagnostics);

/// Duplicates a block, translated in world space. Meshes in it become definitions, which both use.
std::optional<grf::Scene> duplicate_object(const grf::Scene& scene, grf::ScenePathView path,
                                           const grf::Vec3d& offset, grf::Diagnostics& diagnostics);

/// Renames a mesh; a definition is renamed with all references to it.
std::optional<grf::Scene> rename_object(const grf::Scene& scene, grf::ScenePathView path,
                                        const std::string& name, grf::Diagnostics& diagnostics);

}  // namespace editor
