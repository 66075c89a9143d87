#pragma once

#include <string>

#include "grf/scene.h"

namespace scaling {

/// Takes a scene of a path into the editor's document, selects faces in several ways, gives them a BRDF, and
/// undoes that. There only where the editor is built.
void edit(const grf::Scene& scene, const std::string& path);

}  // namespace scaling
