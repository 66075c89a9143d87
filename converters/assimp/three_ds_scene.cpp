#include "converters/assimp/three_ds_scene.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "converters/mesh_operations/vertex_normals.h"
#include "grf/keywords.h"

namespace convert {
namespace {

/// A corner of a face of the file in Assimp's scene.
struct SceneCorner {
  aiMesh* mesh = nullptr;
  unsigned vertex = 0;

  grf::Vec3f position() const {
    const aiVector3D& v = mesh->mVertices[vertex];
    return {v.x, v.y, v.z};
  }
};

using SceneFace = std::array<SceneCorner, 3>;

/// Returns the object of a mesh, whose number is the mesh's name in Assimp.
std::size_t object_of(const aiMesh& mesh) {
  const std::string_view name(mesh.mName.C_Str());
  std::size_t object = std::numeric_limits<std::size_t>::max();
  std::from_chars(name.data(), name.data() + name.size(), object);
  return object;
}

/// Returns the material that Assimp gives to faces without one: one that it adds at the end, or the last one
/// that it takes for a default.
std::size_t default_material(const ThreeDsFile& file, const aiScene& scene) {
  if (scene.mNumMaterials > file.materials.size()) return file.materials.size();
  std::size_t result = ThreeDsFace::NoMaterial;
  for (std::size_t i = 0; i < scene.mNumMaterials; ++i) {
    const aiMaterial& material = *scene.mMaterials[i];
    aiColor3D diffuse;
    material.Get(AI_MATKEY_COLOR_DIFFUSE, diffuse);
    const bool is_grey = diffuse.r == diffuse.g && diffuse.r == diffuse.b;
    const bool has_name = grf::lower_case(material.GetName().C_Str()).find("default") != std::string::npos;
    unsigned maps = 0;
    for (const aiTextureType type :
         {aiTextureType_DIFFUSE, aiTextureType_HEIGHT, aiTextureType_OPACITY, aiTextureType_EMISSIVE,
          aiTextureType_SPECULAR, aiTextureType_SHININESS}) {
      maps += material.GetTextureCount(type);
    }
    if (has_name && is_grey && maps == 0) result = i;
  }
  return result;
}

/// Finds the faces of an object in the scene: each of its meshes has the faces of one material, in the order
/// of the file. Empty if they do not match.
std::vector<SceneFace> faces_in_scene(const ThreeDsObject& object, std::span<aiMesh* const> meshes,
                                      std::size_t default_index) {
  std::vector<SceneFace> faces(object.faces.size());
  std::size_t found = 0;
  for (aiMesh* mesh : meshes) {
    unsigned next = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const std::size_t own = object.faces[i].material;
      if ((own == ThreeDsFace::NoMaterial ? default_index : own) != mesh->mMaterialIndex) continue;
      if (next >= mesh->mNumFaces || mesh->mFaces[next].mNumIndices != 3) return {};
      const aiFace& face = mesh->mFaces[next++];
      for (std::size_t k = 0; k < 3; ++k) {
        if (face.mIndices[k] >= mesh->mNumVertices) return {};
        faces[i][k] = {mesh, face.mIndices[k]};
      }
    }
    if (next != mesh->mNumFaces) return {};
    found += next;
  }
  return found == faces.size() ? faces : std::vector<SceneFace>();
}

class Smoothing {
 public:
  Smoothing(const ThreeDsObject& object, const std::vector<SceneFace>& faces) : object_(object) {
    std::map<std::tuple<float, float, float>, std::size_t> points;
    for (const grf::Vec3f& p : object.positions) {
      point_of_vertex_.push_back(points.emplace(std::tuple(p.x, p.y, p.z), points.size()).first->second);
    }
    corners_of_point_.resize(points.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
      std::array<grf::Vec3f, 3> positions;
      for (std::size_t k = 0; k < 3; ++k) {
        corners_of_point_[point_of(i, k)].emplace_back(i, k);
        positions[k] = faces[i][k].position();
      }
      weighted_normals(std::array{0U, 1U, 2U}, positions, weighted_normals_.emplace_back());
    }
  }

  /// Returns the normal of a corner, zero if it is not smooth.
  grf::Vec3f normal(std::size_t face, std::size_t corner) {
    const std::uint32_t groups = object_.faces[face].groups;
    if (groups == 0) return grf::Vec3f(0);
    const std::size_t point = point_of(face, corner);
    const auto [known, is_new] = normals_.emplace(std::pair(point, groups), grf::Vec3f(0));
    if (is_new) {
      grf::Vec3d sum(0);
      for (const auto& [other, k] : corners_of_point_[point]) {
        if ((object_.faces[other].groups & groups) != 0) sum += weighted_normals_[other][k];
      }
      known->second = unit_normal(sum).value_or(grf::Vec3f(0));
    }
    return known->second;
  }

 private:
  std::size_t point_of(std::size_t face, std::size_t corner) const {
    return point_of_vertex_[object_.faces[face].corners[corner]];
  }

  const ThreeDsObject& object_;
  std::vector<std::size_t> point_of_vertex_;
  std::vector<std::vector<grf::Vec3d>> weighted_normals_;  // by face and corner
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> corners_of_point_;
  std::map<std::pair<std::size_t, std::uint32_t>, grf::Vec3f> normals_;
};

void set_normals(const ThreeDsObject& object, const std::vector<SceneFace>& faces) {
  Smoothing smoothing(object, faces);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const grf::Vec3f normal = smoothing.normal(i, k);
      faces[i][k].mesh->mNormals[faces[i][k].vertex] = {normal.x, normal.y, normal.z};
    }
  }
}

void restore_object(const ThreeDsObject& object, std::span<aiMesh* const> meshes, std::size_t default_index,
                    Losses& losses) {
  const bool has_normals =
      std::all_of(meshes.begin(), meshes.end(), [](const aiMesh* mesh) { return mesh->HasNormals(); });
  const std::vector<SceneFace> faces =
      has_normals ? faces_in_scene(object, meshes, default_index) : std::vector<SceneFace>();
  if (!faces.empty()) set_normals(object, faces);
  for (aiMesh* mesh : meshes) {
    mesh->mName.Set(object.name);
    if (!faces.empty()) continue;
    if (has_normals) std::fill_n(mesh->mNormals, mesh->mNumVertices, aiVector3D());
    losses.add(Loss::SmoothingGroup, mesh->mNumFaces);
  }
}

/// Without nodes in the file, Assimp makes a node per mesh.
void join_objects(aiScene& scene, const std::vector<std::size_t>& object_of_mesh, const ThreeDsFile& file) {
  aiNode& root = *scene.mRootNode;
  if (std::strcmp(root.mName.C_Str(), "<3DSDummyRoot>") != 0) return;
  std::map<std::size_t, std::vector<unsigned>> meshes;
  for (unsigned i = 0; i < object_of_mesh.size(); ++i) meshes[object_of_mesh[i]].push_back(i);
  for (aiNode* node : std::span(root.mChildren, root.mNumChildren)) {
    if (node == nullptr || node->mNumMeshes != 1 || node->mMeshes[0] >= object_of_mesh.size()) continue;
    const std::size_t object = object_of_mesh[node->mMeshes[0]];
    if (object >= file.objects.size()) continue;
    const std::vector<unsigned> all = std::exchange(meshes[object], {});
    delete[] node->mMeshes;
    node->mMeshes = all.empty() ? nullptr : new unsigned[all.size()];
    node->mNumMeshes = static_cast<unsigned>(all.size());
    std::copy(all.begin(), all.end(), node->mMeshes);
    node->mName.Set(file.objects[object].name);
  }
}

}  // namespace

void restore_three_ds(const ThreeDsFile& file, aiScene& scene, Losses& losses) {
  std::vector<std::size_t> object_of_mesh;
  std::map<std::size_t, std::vector<aiMesh*>> meshes;
  for (aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
    object_of_mesh.push_back(object_of(*mesh));
    meshes[object_of_mesh.back()].push_back(mesh);
  }
  const std::size_t default_index = default_material(file, scene);
  for (const auto& [object, parts] : meshes) {
    if (object < file.objects.size()) restore_object(file.objects[object], parts, default_index, losses);
  }
  join_objects(scene, object_of_mesh, file);
}

}  // namespace convert
