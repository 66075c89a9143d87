// A glTF file as tinygltf sees it. This header alone includes tinygltf, for the reader's files in this
// folder.
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
  std::size_t bytes = 0;  ///< of the file and its buffers: what bears out how much it may ask for
  /// Its extras hold a scene of GRF, and nothing was changed since that was written.
  bool is_unchanged_grf = false;
};

/// Reads a `.gltf` or `.glb` file (told by its first bytes) and its buffers, not its images. Nothing is
/// returned after an error: a file that is no glTF 2, a buffer that is missing or too short, an extension
/// that is required and not known. Accessors, views and indices are not checked: see `GltfAccessors`.
std::optional<GltfFile> load_gltf(const std::string& path, grf::Diagnostics& diagnostics);

/// The four bytes that a GLB file begins with.
inline constexpr std::string_view GlbMagic = "glTF";

}  // namespace convert
