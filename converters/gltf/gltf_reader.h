#pragma once

#include <optional>
#include <string>

#include "converters/format.h"

namespace convert {

/// Reads a `.gltf` or `.glb` file: the scene of GRF in its extras if that still holds, else what glTF says.
std::optional<Import> read_gltf(const std::string& path, const ReadOptions& options,
                                grf::Diagnostics& diagnostics);

}  // namespace convert
