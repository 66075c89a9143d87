#pragma once

#include <string>

#include "converters/format.h"

namespace convert {

/// Writes a glTF file, or leaves it unchanged and reports why. A `.gltf` file has its buffer beside it, in a
/// file with the same name and the extension `.bin`, and references images; a `.glb` file embeds both. With
/// an OP file, its cameras are written, too.
bool write_gltf(const grf::Scene& scene, const std::string& path, const WriteOptions& options,
                grf::Diagnostics& diagnostics);
bool write_glb(const grf::Scene& scene, const std::string& path, const WriteOptions& options,
               grf::Diagnostics& diagnostics);

}  // namespace convert
