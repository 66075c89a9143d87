// The node hierarchy of an Assimp scene becomes transforms and instances.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <assimp/scene.h>

#include "grf/math.h"

namespace convert {

/// The mesh indices of one node: the faces of one object, one mesh per material.
using MeshGroup = std::vector<unsigned>;

/// Returns the children of a node, without null ones, which Assimp's RAW importer leaves.
std::vector<const aiNode*> children_of(const aiNode& node);

/// The number of nodes with the same meshes.
using GroupUses = std::map<MeshGroup, std::size_t>;

/// Validates the indices and the depth of the tree: returns an error message, or an empty string. All other
/// functions here require a valid scene.
std::string fault_of(const aiScene& scene);

GroupUses count_uses(const aiNode& root);

MeshGroup group_of(const aiNode& node);

/// Returns the number of nodes with meshes in the subtree of a node.
std::size_t placed_groups(const aiNode& node);

/// Returns the transform to the parent; nothing if it is singular, to float precision, or not affine.
std::optional<grf::Matrix44d> invertible_transform(const aiNode& node);

/// Returns the name of a node; empty for names that Assimp invents.
std::string name_of(const aiNode& node);

}  // namespace convert
