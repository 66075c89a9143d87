#pragma once

#include <optional>
#include <string>

#include "converters/format.h"

namespace convert {

/// Reads a PLY file: by OpenMesh where that takes over all that the file has, else by a reading of our own,
/// which also says what is wrong with a file that OpenMesh cannot read.
std::optional<Import> read_ply(const std::string& path, const ReadOptions& options,
                               grf::Diagnostics& diagnostics);

}  // namespace convert
