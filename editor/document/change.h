#pragma once

#include <cstdint>
#include <vector>

namespace editor {

/// Which parts of the scene an edit, undo or redo touched, so that views update only these. If
/// `is_structural`, anything may differ and objects are renumbered; else the other members are complete.
struct Change {
  bool is_structural = false;         ///< objects were added, removed, or have another geometry
  bool transforms = false;            ///< objects were moved, rotated or scaled
  bool definitions = false;           ///< colours, BRDFs, PDFs or textures of a name differ
  bool lights = false;                ///< area lights or observers differ
  bool names = false;                 ///< names of meshes differ, in the same order of objects
  bool references = false;            ///< faces may refer to other definitions
  std::vector<std::uint32_t> meshes;  ///< meshes with edited surfaces; numbers of the scene's objects

  /// Whether any object, light or observer may have come, gone or moved.
  bool moves_objects() const { return is_structural || transforms || lights; }
};

}  // namespace editor
