// Editing the names of a scene: what is defined, and what refers to it. Each edit gives a new scene, or
// nothing and the reason in the diagnostics.
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

/// How often each definition is referred to: by surfaces of meshes, `use` blocks and terms of `combine`, but
/// for those that stand in what is left out. Definitions that nothing refers to are not there. Keys are into
/// the scene.
std::unordered_map<const grf::Definition*, std::size_t> count_uses(
    const grf::Scene& scene, const std::vector<grf::ScenePath>& without = {});

/// Whether a surface refers to a definition, itself or in a term of its `combine`.
bool names_a_definition(const grf::Surface& surface);

/// An identifier like the text that no definition has, and no model of the scene as its keyword.
std::string fresh_name(const grf::Scene& scene, const std::string& wanted);

struct Defined {
  grf::Scene scene;
  std::string name;     ///< the one that was wanted, or a fresh one where that is taken
  grf::ScenePath path;  ///< of the definition
};

/// Defines something for the whole scene. Names in the body have to mean something there.
std::optional<Defined> define(const grf::Scene& scene, const std::string& wanted_name,
                              grf::Definition::Body body, grf::Diagnostics& diagnostics);

/// Gives a definition another body of the same kind.
std::optional<grf::Scene> change_definition(const grf::Scene& scene, grf::ScenePathView path,
                                            const grf::Definition::Body& body, grf::Diagnostics& diagnostics);

/// Renames a definition and all that refers to it. Refused where the name is no identifier, or is another
/// definition's at a place that matters.
std::optional<grf::Scene> rename_definition(const grf::Scene& scene, grf::ScenePathView path,
                                            const std::string& name, grf::Diagnostics& diagnostics);

/// Takes away all definitions that nothing refers to, and then those that only these referred to. The scene
/// itself if there is none.
grf::Scene remove_unused_definitions(const grf::Scene& scene);

/// The faces that refer to the definition at a place by its name, or that are of the mesh there.
FaceSelection faces_with(const grf::Scene& scene, const SceneObjects& objects, grf::ScenePathView path);

}  // namespace editor
