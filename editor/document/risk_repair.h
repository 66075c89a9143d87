// Risks of a scene are repaired by edits of its faces and objects.
#pragma once

#include <optional>

#include "converters/risks/risk.h"
#include "editor/document/face_selection.h"
#include "editor/document/scene_objects.h"
#include "grf/scene.h"

namespace editor {

/// Returns the faces of a risk: those that it lists, or all of its mesh. Empty if its object is an area light
/// or an instance.
FaceSelection faces_of(const convert::Risk& risk, const SceneObjects& objects);

/// Returns whether `repaired` can remove risks of this kind.
bool has_repair(convert::RiskKind kind);

/// Repairs a risk of the scene, whose objects are given: deletes faces without area, duplicate faces and
/// meshes; flips inward faces; recomputes normals that point to the back; projects texture coordinates from a
/// box. Returns nothing if there is no repair.
std::optional<grf::Scene> repaired(const grf::Scene& scene, const SceneObjects& objects,
                                   const convert::Risk& risk);

}  // namespace editor
