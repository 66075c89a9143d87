#include "editor/document/apply_transforms.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "editor/document/scene_places.h"

namespace editor {
namespace {

using grf::Matrix44d;
using grf::Vec3d;
using grf::Vec3f;

Vec3f turned(const Vec3f& direction, const Matrix44d& matrix) {
  Vec3d result(0);
  matrix.multDirMatrix(Vec3d(direction), result);
  return Vec3f(result);
}

/// Transforms what can take up a matrix, and reports what cannot.
class TransformTaker {
 public:
  explicit TransformTaker(const Matrix44d& matrix)
      : matrix_(matrix), normal_matrix_(matrix.inverse().transposed()), mirrors_(matrix.determinant() < 0) {}

  void take(grf::BlockList& list) {
    for (grf::Block& block : list.blocks) std::visit([this](auto& content) { take(content); }, block.content);
  }
  /// The first thing that cannot be transformed; empty if there is none.
  const std::string& obstacle() const { return obstacle_; }

 private:
  void take(grf::Shared<grf::Mesh>& mesh) {
    grf::Geometry geometry = *mesh->geometry;
    for (Vec3f& position : geometry.positions) position = Vec3f(Vec3d(position) * matrix_);
    for (std::size_t i = 0; i < geometry.positions.size(); ++i) {
      if (geometry.normals.has(i))
        geometry.normals.set(i, turned(geometry.normals[i], normal_matrix_).normalized());
    }
    for (std::size_t face = 0; mirrors_ && face < geometry.face_count(); ++face) geometry.reverse_face(face);
    mesh.edit().geometry = std::move(geometry);
  }
  void take(grf::MeshLight& light) { take(light.mesh); }
  void take(grf::AreaLight& light) {
    light.corner = Vec3f(Vec3d(light.corner) * matrix_);
    light.edge1 = turned(light.edge1, matrix_);
    light.edge2 = turned(light.edge2, matrix_);
    if (mirrors_) std::swap(light.edge1, light.edge2);  // it emits along their cross product
  }
  void take(grf::DefinitionScope& scope) { take(scope.body); }
  void take(const grf::Use&) { refuse("an instance"); }
  void take(const grf::Include&) { refuse("an included file"); }
  void take(const grf::Params&) { refuse("an observer"); }
  void take(const grf::Transform&) { refuse("another transform, which has to be applied first"); }

  void refuse(const char* what) {
    if (obstacle_.empty()) obstacle_ = what;
  }

  Matrix44d matrix_;
  Matrix44d normal_matrix_;
  bool mirrors_;
  std::string obstacle_;
};

}  // namespace

std::optional<TransformedObjects> apply_transforms(const grf::Scene& scene,
                                                   const std::vector<grf::ScenePath>& paths,
                                                   grf::Diagnostics& diagnostics) {
  grf::Scene applied = scene;
  for (const grf::ScenePath& path : moved_blocks(scene, paths)) {
    const grf::ScenePath place = own_transform(scene, path);
    if (place.empty()) continue;
    auto& transform = std::get<grf::Transform>(grf::find(applied, place).block->content);
    TransformTaker taker(grf::matrix_of(transform.steps));
    taker.take(transform.body);
    if (taker.obstacle().empty()) continue;
    diagnostics.error({}, "the transform cannot be applied: it moves " + taker.obstacle());
    return std::nullopt;
  }
  return reset_transforms(applied, paths, diagnostics);
}

}  // namespace editor
