// Edits the named definitions of a scene and the references to them. Each edit returns a new scene, or
// nothing with the reason in the diagnostics.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "editor/document/face_selection.h"
#include "editor/document/scene_objects.h"
#include "editor/document/scene_places.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "grf/scene_path.h"

namespace editor {

/// Counts the references to each definition: from surfaces of meshes, `use` blocks and terms of `combine`,
/// except those inside the paths `without`. Definitions without references are not in the map. Keys
/// point into the scene.
std::unordered_map<const grf::Definition*, std::size_t> count_uses(
    const grf::Scene& scene, const std::vector<grf::ScenePath>& without = {});

/// Whether a surface refers to a definition, directly or in a term of its `combine`.
bool names_a_definition(const grf::Surface& surface);

/// Returns an unused identifier like `wanted`, which is no keyword of a model in the scene, either.
std::string fresh_name(const grf::Scene& scene, const std::string& wanted);

struct Defined {
  grf::Scene scene;
  std::string name;     ///< the wanted one, or a fresh one if that is in use
  grf::ScenePath path;  ///< of the definition
};

/// Whether the references inside a block or a definition have the same meanings in the scope of another
/// place; else reports the first that has not. The place is a path whose last index is that of a block.
bool keeps_references(const grf::Scene& scene, const std::vector<grf::ScenePath>& blocks,
                      grf::ScenePathView place, grf::Diagnostics& diagnostics);

/// Adds a definition for the whole scene. References in the body must be valid there.
std::optional<Defined> define(const grf::Scene& scene, const std::string& wanted_name,
                              grf::Definition::Body body, grf::Diagnostics& diagnostics);

/// Replaces the body of a definition by one of the same kind.
std::optional<grf::Scene> change_definition(const grf::Scene& scene, grf::ScenePathView path,
                                            const grf::Definition::Body& body, grf::Diagnostics& diagnostics);

/// Renames a definition and all references to it. Fails if the name is no identifier, or would collide with
/// another definition in scope.
std::optional<grf::Scene> rename_definition(const grf::Scene& scene, grf::ScenePathView path,
                                            const std::string& name, grf::Diagnostics& diagnostics);

/// Removes all definitions without references, and then those that only these referred to. Returns the scene
/// itself if there is none.
grf::Scene remove_unused_definitions(const grf::Scene& scene);

/// The faces that refer to the definition at a path by its name, or that belong to the mesh there.
FaceSelection faces_with(const grf::Scene& scene, const SceneObjects& objects, grf::ScenePathView path);

}  // namespace editor
