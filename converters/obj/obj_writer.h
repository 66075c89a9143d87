#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

/// Writes an OBJ file, and its material library beside it (the same name with `.mtl`) if there are materials;
/// or leaves both unchanged and reports why. Losses are reported in one warning per kind.
bool write_obj(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace convert
