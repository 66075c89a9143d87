#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

/// Writes a glTF file, or leaves it unchanged and reports why. A `.gltf` file has its buffer beside it, in a
/// file with the same name and the extension `.bin`, and references images; a `.glb` file embeds both.
bool write_gltf(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics);
bool write_glb(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace convert
