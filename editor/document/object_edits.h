// Moving, copying, naming and taking away what stands in a scene. Each edit gives a new scene, or nothing and
// the reason in the diagnostics.
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

/// Moves a block in the world. Where it stands alone in a transform, or is one, that moves it; else it gets
/// one of its own, which then stands at the path.
std::optional<grf::Scene> move_object(const grf::Scene& scene, grf::ScenePathView path,
                                      const grf::Vec3d& offset, grf::Diagnostics& diagnostics);

/// Deletes blocks, definitions that nothing else refers to, and observers, whose `params` goes with the last
/// of them.
std::optional<grf::Scene> remove_objects(const grf::Scene& scene, const std::vector<grf::ScenePath>& paths,
                                         const std::vector<ObserverObject>& observers,
                                         grf::Diagnostics& diagnostics);

/// Puts a block there once more, moved in the world. Meshes in it become definitions, which both use.
std::optional<grf::Scene> duplicate_object(const grf::Scene& scene, grf::ScenePathView path,
                                           const grf::Vec3d& offset, grf::Diagnostics& diagnostics);

/// Names a mesh; a definition is renamed with all that refers to it.
std::optional<grf::Scene> rename_object(const grf::Scene& scene, grf::ScenePathView path,
                                        const std::string& name, grf::Diagnostics& diagnostics);

}  // namespace editor
