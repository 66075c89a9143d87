// The tree of nodes of a scene of Assimp's: what it places where.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <assimp/scene.h>

#include "grf/math.h"

namespace convert {

/// The meshes of one node, by their indices: the faces of one object, a mesh for each of its materials.
using MeshGroup = std::vector<unsigned>;

/// The nodes below a node. Assimp's reader of RAW leaves some of them null, which are not among these.
std::vector<const aiNode*> children_of(const aiNode& node);

/// How many nodes have the same meshes.
using GroupUses = std::map<MeshGroup, std::size_t>;

/// What is wrong with an index or the depth of the tree; empty if nothing is. All else here is for scenes of
/// which nothing is wrong.
std::string fault_of(const aiScene& scene);

GroupUses count_uses(const aiNode& root);

MeshGroup group_of(const aiNode& node);

/// How many nodes with meshes there are from this one down.
std::size_t placed_groups(const aiNode& node);

/// The transform to the parent; nothing if it has no inverse, within what its floats can tell, or is no
/// affine one.
std::optional<grf::Matrix44d> invertible_transform(const aiNode& node);

/// The name of a node; empty for names that Assimp makes up.
std::string name_of(const aiNode& node);

}  // namespace convert
