#pragma once

#include <cstdint>
#include <vector>

namespace editor {

/// What changed of the project that is edited. Where `is_structural` holds, anything of the scene may be
/// another, and objects have other numbers; else the rest says all.
struct Change {
  bool is_structural = false;         ///< objects came, went, or got another place, name or geometry
  bool definitions = false;           ///< what colours, BRDFs, PDFs or textures of a name are
  bool lights = false;                ///< area lights or observers
  std::vector<std::uint32_t> meshes;  ///< whose faces have other surfaces; numbers of the scene's objects

  /// Whether faces of any mesh may look different.
  bool has_other_surfaces() const { return is_structural || definitions || !meshes.empty(); }
};

}  // namespace editor
