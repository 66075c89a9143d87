#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "converters/gltf/gltf_accessors.h"
#include "converters/gltf/gltf_file.h"
#include "grf/math.h"

namespace convert {

/// The node hierarchies of a glTF file (glTF 2.0, section 3.5).
class GltfNodes {
 public:
  /// The maximum depth of nodes: deeper ones are an error, as are blocks of GRF.
  static constexpr int Deepest = 900;

  GltfNodes(const GltfFile& file, GltfAccessors& accessors) : file_(file), accessors_(accessors) {}

  /// Validates that nodes are trees, and computes their transforms; returns false after an error.
  bool load();

  /// Returns the root nodes of the file's default scene, or all nodes without a parent if it has none.
  const std::vector<int>& roots() const { return roots_; }

  /// Returns a node's transform to its parent, and to the scene.
  const grf::Matrix44d& to_parent(int node) const { return to_parent_[static_cast<std::size_t>(node)]; }
  grf::Matrix44d to_scene(int node) const;

  /// Returns the joint matrices of a skin, from the mesh to the scene (including inverse bind matrices), or
  /// nothing after an error.
  std::optional<std::vector<grf::Matrix44d>> joints(int index);

 private:
  bool find_parents();
  bool find_roots();
  bool find_transforms();
  bool exists(int node) const {
    return node >= 0 && static_cast<std::size_t>(node) < file_.model.nodes.size();
  }

  const GltfFile& file_;
  GltfAccessors& accessors_;
  std::vector<int> parents_;  ///< by node; -1: none
  std::vector<int> roots_;
  std::vector<grf::Matrix44d> to_parent_;
};

}  // namespace convert
