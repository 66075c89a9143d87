#pragma once

#include <string>
#include <string_view>

#include "converters/gltf/gltf_file.h"
#include "grf/diagnostics.h"

namespace convert {

/// Decompresses the buffer views of EXT_meshopt_compression and the primitives of KHR_draco_mesh_compression:
/// both refer to plain buffers afterwards, which are added to the file. Returns false after an error: damaged
/// data, or more of it than a file of this size is expected to have.
bool decompress(GltfFile& file, grf::Diagnostics& diagnostics);

/// Fills in what tinygltf asks of a file and compressed files may lack: bytes of fallback buffers, which
/// stand in for the compressed views of EXT_meshopt_compression, and buffer views of the indices that
/// KHR_draco_mesh_compression holds. Returns the JSON, or an empty text if it lacks nothing.
std::string with_placeholders(std::string_view json);

}  // namespace convert
