// Which side of the faces is outside: what Debian's models enclose, with its sign, as Assimp reads them by
// itself and as our readers do. A reader that turns faces over, or mirrors a mesh and not its faces, has
// another sign.
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include "grf/visit.h"
#include "tests/converters/assimp/golden_models.h"
#include "tests/converters/model_files.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using VolumePoint = std::tuple<double, double, double>;

/// Collects faces and what they enclose. A mirrored mesh keeps its fronts, as GRF, glTF and COLLADA have it.
class EnclosedVolume {
 public:
  void add(const std::vector<grf::Vec3d>& corners, bool is_mirrored) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const double part = corners[0].dot(corners[i].cross(corners[i + 1])) / 6;
      sum_ += is_mirrored ? -part : part;
      sum_of_sizes_ += std::abs(part);
    }
    if (++faces_ > MostFaces) return;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const grf::Vec3d& a = corners[i];
      const grf::Vec3d& b = corners[(i + 1) % corners.size()];
      const VolumePoint from(a.x, a.y, a.z);
      const VolumePoint to(b.x, b.y, b.z);
      if (from == to) continue;
      ++edges_[{from, to}];
      --edges_[{to, from}];
    }
  }

  double signed_volume() const { return sum_; }
  double sum_of_sizes() const { return sum_of_sizes_; }
  /// Whether each edge has as many faces on one side as on the other; false of large models, for whose edges
  /// nobody waits.
  bool is_closed() const {
    return !edges_.empty() && faces_ <= MostFaces &&
           std::all_of(edges_.begin(), edges_.end(), [](const auto& edge) { return edge.second == 0; });
  }

 private:
  static constexpr std::size_t MostFaces = 5000;

  std::size_t faces_ = 0;
  double sum_ = 0;
  double sum_of_sizes_ = 0;
  std::map<std::pair<VolumePoint, VolumePoint>, int> edges_;
};

void add_node_volume(const aiScene& scene, const aiNode& node, const aiMatrix4x4& to_world,
                     EnclosedVolume& volume) {
  for (const unsigned index : std::span(node.mMeshes, node.mNumMeshes)) {
    const aiMesh& mesh = *scene.mMeshes[index];
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
      std::vector<grf::Vec3d> corners;
      for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) {
        const aiVector3D p = to_world * mesh.mVertices[vertex];
        corners.emplace_back(p.x, p.y, p.z);
      }
      if (corners.size() > 2) volume.add(corners, to_world.Determinant() < 0);
    }
  }
  for (const aiNode* child : std::span(node.mChildren, node.mNumChildren)) {
    if (child != nullptr) add_node_volume(scene, *child, to_world * child->mTransformation, volume);
  }
}

EnclosedVolume volume_by_assimp(const std::string& path, std::string_view format) {
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_AC_EVAL_SUBDIVISION, false);
  const aiScene* scene = importer.ReadFile(path, 0);
  EnclosedVolume volume;
  if (scene == nullptr || scene->mRootNode == nullptr) return volume;
  // Assimp turns and scales scenes of some formats by their roots, and our readers take that back.
  const std::set<std::string_view> converted = {"3ds", "dxf", "collada", "fbx"};
  const aiNode& root = *scene->mRootNode;
  add_node_volume(*scene, root, converted.contains(format) ? aiMatrix4x4() : root.mTransformation, volume);
  return volume;
}

EnclosedVolume volume_of_scene(const grf::Scene& scene) {
  EnclosedVolume volume;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      std::vector<grf::Vec3d> corners;
      for (const std::uint32_t vertex : mesh.face(i)) {
        placement.to_world.multVecMatrix(grf::Vec3d(mesh.geometry->positions[vertex]),
                                         corners.emplace_back());
      }
      volume.add(corners, placement.to_world.determinant() < 0);
    }
  };
  grf::visit(scene, visitor);
  return volume;
}

/// Models of closed surfaces whose author has their fronts inside: Assimp has them so, too.
const std::set<std::string>& inside_out_models() {
  static const std::set<std::string> names = {"BLEND/TorusLightsCams_250_compressed.blend",
                                              "FBX/animation_with_skeleton.fbx"};
  return names;
}

TEST(SignedVolume, IsThatWhichAssimpHas) {
  std::size_t compared = 0;
  std::size_t closed = 0;
  for (const auto& formats : {formats_of_assimp_models(), formats_of_obj_models(), formats_of_ply_models(),
                              formats_of_gltf_models()}) {
    for (const std::string& path : model_files(formats)) {
      const std::string name = short_name(path);
      if (expected_errors().contains(name)) continue;
      const Reading reading = read_path(path);
      if (!reading.scene) continue;
      grf::Diagnostics diagnostics;
      const EnclosedVolume ours = volume_of_scene(*reading.scene);
      const EnclosedVolume theirs = volume_by_assimp(path, recognise(path, diagnostics)->name);
      if (theirs.sum_of_sizes() == 0) continue;
      ++compared;
      EXPECT_NEAR(ours.signed_volume(), theirs.signed_volume(), 1e-4 * theirs.sum_of_sizes()) << name;
      if (!ours.is_closed()) continue;
      ++closed;
      EXPECT_EQ(ours.signed_volume() < 0, inside_out_models().contains(name)) << name;
    }
  }
  EXPECT_GE(compared, 250U);
  EXPECT_GE(closed, 40U);
}

}  // namespace
}  // namespace convert
