#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

/// Replaces the file, or leaves it as it was and says why. The `.gltf` file has its buffer beside it, in a
/// file with the same name and the extension `.bin`, and names images; the `.glb` file has both inside.
bool write_gltf(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics);
bool write_glb(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace convert
