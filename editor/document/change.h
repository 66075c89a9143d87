#pragma once

#include <cstdint>
#include <vector>

namespace editor {

/// A change says which parts of the scene an edit, an undo or a redo touched, so that views update these
/// alone. Where `is_structural` holds, anything may be another, and objects have other numbers; else the rest
/// says all.
struct Change {
  bool is_structural = false;         ///< objects came, went, or got another place or geometry
  bool definitions = false;           ///< what colours, BRDFs, PDFs or textures of a name are
  bool lights = false;                ///< area lights or observers
  bool names = false;                 ///< of meshes, with no other order of objects
  bool references = false;            ///< faces name other definitions than before, or may do so
  std::vector<std::uint32_t> meshes;  ///< whose faces have other surfaces; numbers of the scene's objects
};

}  // namespace editor
