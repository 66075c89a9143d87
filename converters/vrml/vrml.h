#pragma once

#include "converters/format.h"

namespace convert {

/// VRML 1.0 and VRML97, also compressed by gzip.
Format vrml_format();

/// What bytes hold that are in memory, as though they stood in a file of that path.
std::optional<Import> read_vrml_bytes(std::string_view bytes, const std::string& path,
                                      grf::Diagnostics& diagnostics);

}  // namespace convert
