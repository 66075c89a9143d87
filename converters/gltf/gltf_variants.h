#pragma once

#include <string>

#include "converters/gltf/gltf_file.h"
#include "grf/diagnostics.h"

namespace convert {

/// Assigns the materials of a variant (KHR_materials_variants) to the primitives of a file; an empty name
/// keeps the default materials, with a note that names the variants that there are. Returns false after an
/// error: the file has no variant of this name.
bool choose_variant(GltfFile& file, const std::string& name, grf::Diagnostics& diagnostics);

}  // namespace convert
