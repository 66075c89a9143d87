// Edits objects of a scene: duplicate, rename and delete. Each edit returns a new scene, or nothing
// with the reason in the diagnostics.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/document/object_placement.h"
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

/// Turns instances into meshes of their own, with the definitions' names. Fails if a name that a mesh uses
/// has another meaning at the instance, and for included files.
std::optional<TransformedObjects> make_single(const grf::Scene& scene,
                                              const std::vector<grf::ScenePath>& paths,
                                              grf::Diagnostics& diagnostics);

/// Turns a mesh into a definition in the innermost scope, with a fresh name like its own, and an instance of
/// that; not in an included file. The path is that of the instance.
std::optional<TransformedObjects> make_instance(const grf::Scene& scene, const grf::ScenePath& path,
                                                grf::Diagnostics& diagnostics);

/// Renames a mesh; a definition is renamed with all references to it.
std::optional<grf::Scene> rename_object(const grf::Scene& scene, grf::ScenePathView path,
                                        const std::string& name, grf::Diagnostics& diagnostics);

}  // namespace editor
