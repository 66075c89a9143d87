#include "tests/converters/gltf/assimp_count.h"

#include <set>
#include <span>
#include <tuple>
#include <vector>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include "grf/visit.h"

namespace convert {
namespace {

using Position = std::tuple<float, float, float>;

double fan_area(const std::vector<grf::Vec3d>& corners) {
  grf::Vec3d sum(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
  }
  return 0.5 * sum.length();
}

void add_face(const std::vector<grf::Vec3d>& corners, ModelCount& count) {
  ++count.faces;
  count.area += fan_area(corners);
  for (const grf::Vec3d& corner : corners) count.bounds.extendBy(corner);
}

void add_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& to_world, ModelCount& count) {
  const aiMatrix4x4 matrix = to_world * node.mTransformation;
  std::set<Position> positions;
  for (const unsigned index : std::span(node.mMeshes, node.mNumMeshes)) {
    const aiMesh& mesh = *scene.mMeshes[index];
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
      if (face.mNumIndices < 3) continue;
      std::vector<grf::Vec3d> corners;
      for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) {
        const aiVector3D& local = mesh.mVertices[vertex];
        const aiVector3D moved = matrix * local;
        corners.emplace_back(moved.x, moved.y, moved.z);
        positions.insert({local.x, local.y, local.z});
      }
      add_face(corners, count);
    }
  }
  count.positions += positions.size();
  for (const aiNode* child : std::span(node.mChildren, node.mNumChildren))
    add_node(scene, *child, matrix, count);
}

}  // namespace

std::optional<ModelCount> assimp_count(const std::string& path) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, 0);
  if (scene == nullptr || scene->mRootNode == nullptr) return std::nullopt;
  ModelCount count;
  add_node(*scene, *scene->mRootNode, {}, count);
  return count;
}

ModelCount count_of(const grf::Scene& scene) {
  ModelCount count;
  grf::SceneVisitor visitor;
  const auto add = [&](const grf::Mesh& mesh, const grf::Matrix44d& to_world) {
    std::set<Position> positions;
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      std::vector<grf::Vec3d> corners;
      for (const std::uint32_t corner : mesh.face(i)) {
        const grf::Vec3f& local = mesh.geometry->positions[corner];
        grf::Vec3d moved;
        to_world.multVecMatrix(grf::Vec3d(local), moved);
        corners.push_back(moved);
        positions.insert({local.x, local.y, local.z});
      }
      add_face(corners, count);
    }
    count.positions += positions.size();
  };
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    add(mesh, placement.to_world);
  };
  visitor.mesh_light = [&](const grf::MeshLight& light, const grf::Placement& placement, const grf::Block&) {
    add(*light.mesh, placement.to_world);
  };
  grf::visit(scene, visitor);
  return count;
}

}  // namespace convert
