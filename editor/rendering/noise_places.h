// Finds the lamps and faces in a document that `bpt noise` names.
#pragma once

#include <string>

#include "editor/document/document.h"
#include "editor/rendering/noise_results.h"

namespace editor {

/// The faces that have this BRDF and, unless it is empty, this sampling scheme, as written in the scene.
FaceSelection faces_with(const Document& document, const std::string& brdf, const std::string& scheme);

/// Selects what a share is of: the area light, the emitting faces of a mesh, or the faces with a BRDF.
/// Returns whether there is such a thing.
bool select_part(Document& document, const NoiseShareRow& part);

/// Writes a change to the render options, or to the faces with its BRDF, as one undo step.
void apply_change(Document& document, const NoiseTrial& change, const QString& title);

}  // namespace editor
