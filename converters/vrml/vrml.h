#pragma once

#include "converters/format.h"

namespace convert {

/// The format VRML, 1.0 and 97, also compressed by gzip.
Format vrml_format();

/// Reads bytes in memory as if they were a file of that path.
std::optional<Import> read_vrml_bytes(std::string_view bytes, const std::string& path,
                                      grf::Diagnostics& diagnostics);

}  // namespace convert
