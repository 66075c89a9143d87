#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "converters/gltf/gltf_accessors.h"
#include "converters/gltf/gltf_file.h"
#include "grf/math.h"

namespace convert {

/// The nodes of a glTF file as trees (glTF 2.0, section 3.5).
class GltfNodes {
 public:
  /// Nodes in more than this many others are an error, as are blocks of GRF.
  static constexpr int Deepest = 900;

  GltfNodes(const GltfFile& file, GltfAccessors& accessors) : file_(file), accessors_(accessors) {}

  /// Checks that nodes are trees, and works out their transforms; false after an error.
  bool load();

  /// The nodes that stand in the file's default scene; all that are no other's children if it has none.
  const std::vector<int>& roots() const { return roots_; }

  /// From a node to what it stands in, and to the scene.
  const grf::Matrix44d& to_parent(int node) const { return to_parent_[static_cast<std::size_t>(node)]; }
  grf::Matrix44d to_scene(int node) const;

  /// What moves vertices to where the joints of a skin are, from the mesh to the scene. Nothing is returned
  /// after an error.
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
  std::vector<int> parents_;  ///< of each node; -1: none
  std::vector<int> roots_;
  std::vector<grf::Matrix44d> to_parent_;
};

}  // namespace convert
