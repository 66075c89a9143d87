#pragma once

#include <optional>
#include <string>

#include "converters/format.h"

namespace convert {

/// Reads a PLY file, as text or binary. Returns nothing after an error, which has the location in the file.
std::optional<Import> read_ply(const std::string& path, const ReadOptions& options,
                               grf::Diagnostics& diagnostics);

}  // namespace convert
