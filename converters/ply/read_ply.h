#pragma once

#include <optional>
#include <string>

#include "converters/format.h"

namespace convert {

/// Reads a PLY file, as text or binary. Nothing is returned after an error, which says where the file is
/// broken.
std::optional<Import> read_ply(const std::string& path, const ReadOptions& options,
                               grf::Diagnostics& diagnostics);

}  // namespace convert
