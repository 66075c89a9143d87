#pragma once

#include <optional>
#include <string>

#include "converters/format.h"

namespace convert {

/// Reads a `.gltf` or `.glb` file: the GRF scene in its extras if the file is unchanged, else the glTF scene.
std::optional<Import> read_gltf(const std::string& path, const ReadOptions& options,
                                grf::Diagnostics& diagnostics);

}  // namespace convert
