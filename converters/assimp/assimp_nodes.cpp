#include "converters/assimp/assimp_nodes.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "converters/assimp/assimp_import.h"

namespace convert {
namespace {

/// The maximum depth of the tree: a level may become two nested blocks, of which GRF allows 1,000.
constexpr std::size_t DeepestTree = 500;

std::string mesh_fault(const aiMesh& mesh, unsigned material_count) {
  if (mesh.mMaterialIndex >= material_count) {
    return fmt::format("material {} of {}", mesh.mMaterialIndex, material_count);
  }
  for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
    for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) {
      if (vertex >= mesh.mNumVertices || mesh.mVertices == nullptr) {
        return fmt::format("vertex {} of {}", vertex, mesh.mNumVertices);
      }
    }
  }
  return "";
}

std::string node_fault(const aiNode& node, unsigned mesh_count, std::size_t depth) {
  if (depth > DeepestTree) return fmt::format("objects are nested deeper than {}", DeepestTree);
  for (const unsigned mesh : std::span(node.mMeshes, node.mNumMeshes)) {
    if (mesh >= mesh_count) return fmt::format("mesh {} of {}", mesh, mesh_count);
  }
  for (const aiNode* child : children_of(node)) {
    if (std::string fault = node_fault(*child, mesh_count, depth + 1); !fault.empty()) return fault;
  }
  return "";
}

void add_uses(const aiNode& node, GroupUses& uses) {
  if (node.mNumMeshes > 0) ++uses[group_of(node)];
  for (const aiNode* child : children_of(node)) add_uses(*child, uses);
}

// Assimp uses column vectors, and Imath row vectors.
grf::Matrix44d transposed(const aiMatrix4x4& m) {
  return grf::Matrix44d(m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4,
                        m.c4, m.d4);
}

bool is_finite(const grf::Matrix44d& matrix) {
  return std::all_of(matrix.getValue(), matrix.getValue() + 16, [](double x) { return std::isfinite(x); });
}

}  // namespace

std::vector<const aiNode*> children_of(const aiNode& node) {
  std::vector<const aiNode*> children(node.mChildren, node.mChildren + node.mNumChildren);
  children.erase(std::remove(children.begin(), children.end(), nullptr), children.end());
  return children;
}

std::string fault_of(const aiScene& scene) {
  if (scene.mRootNode == nullptr) return "the file has no objects";
  for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
    if (std::string fault = mesh_fault(*mesh, scene.mNumMaterials); !fault.empty()) {
      return fmt::format("an index is out of range: {}", fault);
    }
  }
  return node_fault(*scene.mRootNode, scene.mNumMeshes, 0);
}

GroupUses count_uses(const aiNode& root) {
  GroupUses uses;
  add_uses(root, uses);
  return uses;
}

MeshGroup group_of(const aiNode& node) { return {node.mMeshes, node.mMeshes + node.mNumMeshes}; }

std::size_t placed_groups(const aiNode& node) {
  std::size_t count = node.mNumMeshes > 0 ? 1 : 0;
  for (const aiNode* child : children_of(node)) count += placed_groups(*child);
  return count;
}

std::optional<grf::Matrix44d> invertible_transform(const aiNode& node) {
  grf::Matrix44d matrix = transposed(node.mTransformation);
  const bool is_affine = matrix[0][3] == 0 && matrix[1][3] == 0 && matrix[2][3] == 0 && matrix[3][3] != 0;
  if (!is_affine || !is_finite(matrix)) return {};
  if (matrix[3][3] != 1) matrix *= 1 / matrix[3][3];
  matrix[3][3] = 1;
  double longest = 1;  // the determinant for orthogonal axes
  for (int i = 0; i < 3; ++i) longest *= grf::Vec3d(matrix[i][0], matrix[i][1], matrix[i][2]).length();
  constexpr double FloatsCannotTell = 1e-7;
  const double volume = std::abs(matrix.determinant());
  if (!std::isfinite(longest) || longest == 0 || volume < FloatsCannotTell * longest) return {};
  return matrix;
}

std::string name_of(const aiNode& node) {
  std::string name = text_of(node.mName);
  const bool is_made_up = name.starts_with("<") && name.ends_with(">");
  return is_made_up ? "" : name;
}

}  // namespace convert
