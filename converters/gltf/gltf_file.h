// tinygltf loads glTF files. Only this header includes tinygltf, for the reader's files in this folder.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <tiny_gltf.h>

#include "grf/diagnostics.h"

namespace convert {

struct GltfFile {
  std::string path;
  tinygltf::Model model;
  std::size_t bytes = 0;  ///< size of the file and its buffers, which limits the work that it may cause
  /// Whether its extras hold a scene of GRF and the file was not changed since they were written.
  bool is_unchanged_grf = false;
};

/// Loads a `.gltf` or `.glb` file (detected from its first bytes) and its buffers, not its images. Returns
/// nothing after an error: a file that is not glTF 2, a buffer that is missing or too short, a required but
/// unsupported extension. Accessors, views and indices are not validated: see `GltfAccessors`.
std::optional<GltfFile> load_gltf(const std::string& path, grf::Diagnostics& diagnostics);

/// The magic number of a GLB file, its first four bytes.
inline constexpr std::string_view GlbMagic = "glTF";

}  // namespace convert
