// Copies and pastes the surface of a face as GRF text.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "editor/document/scene_places.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "grf/surface.h"

namespace editor {

/// Returns a material as a GRF scene that can be read on its own: a square with the surface, inside the
/// definitions that it needs, with absolute names of files. `mesh` is the path of the mesh that has the
/// surface, and `file` the scene's file.
std::string material_text(const grf::Scene& scene, grf::ScenePathView mesh, const grf::Surface& surface,
                          const std::string& file);

/// A scene with the definitions that a material needs, and the surface that refers to them.
struct PastedMaterial {
  grf::Scene scene;
  grf::Surface surface;
};

/// Reads a material: the surface of the first face of a GRF scene. Definitions that the scene lacks are added
/// to it, under other names where theirs are in use; `in_scope` are those that the receiving faces can name.
/// Returns nothing, with the reason in the diagnostics, for text that is no GRF scene with a mesh.
std::optional<PastedMaterial> paste_material(const grf::Scene& scene,
                                             const std::vector<PlacedDefinition>& in_scope,
                                             const std::string& text, grf::Diagnostics& diagnostics);

}  // namespace editor
