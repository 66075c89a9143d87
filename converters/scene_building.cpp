#include "converters/scene_building.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>
#include <utility>
#include <variant>

#include <Eigen/LU>
#include <Eigen/SVD>

#include "converters/text_encoding.h"
#include "grf/keywords.h"
#include "grf/vertex_tree.h"
#include "grf/visit.h"
#include "grf/write.h"

namespace convert {
namespace {

using Kind = grf::TransformStep::Kind;
using grf::Matrix44d;

/// Returns the Euler angles of a rotation (of row vectors) about x, then y, then z.
grf::Vec3f angles_of(const Eigen::Matrix3d& rotation) {
  // (0, 2) is -sin y. At gimbal lock, where x and z rotate about one axis, x gets the whole angle.
  const double sine = std::clamp(-rotation(0, 2), -1.0, 1.0);
  const double cosine = std::hypot(rotation(0, 0), rotation(0, 1));
  constexpr double Degenerate = 1e-9;
  const double y = std::atan2(sine, cosine);
  if (cosine < Degenerate) {
    const double x = std::atan2(-rotation(2, 1), rotation(1, 1));
    return grf::Vec3f(grf::Vec3d(x, y, 0));
  }
  const double x = std::atan2(rotation(1, 2), rotation(2, 2));
  const double z = std::atan2(rotation(0, 1), rotation(0, 0));
  return grf::Vec3f(grf::Vec3d(x, y, z));
}

bool is_diagonal(const Matrix44d& matrix) {
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (i != k && matrix[i][k] != 0) return false;
    }
  }
  return true;
}

void append(std::vector<grf::TransformStep>& steps, Kind kind, const grf::Vec3f& value) {
  if (value != grf::Vec3f(kind == Kind::Scale ? 1.0F : 0.0F)) steps.push_back({kind, value});
}

void append_linear_part(std::vector<grf::TransformStep>& steps, const Matrix44d& matrix) {
  if (is_diagonal(matrix)) {
    append(steps, Kind::Scale, grf::Vec3f(grf::Vec3d(matrix[0][0], matrix[1][1], matrix[2][2])));
    return;
  }
  Eigen::Matrix3d linear;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) linear(i, k) = matrix[i][k];
  }
  const Eigen::Vector3d lengths = linear.rowwise().norm();
  const Eigen::Matrix3d unit = lengths.cwiseInverse().asDiagonal() * linear;
  constexpr double Orthogonal = 1e-6;
  if ((unit * unit.transpose()).isIdentity(Orthogonal)) {  // a scale, then a rotation
    const double sign = unit.determinant() < 0 ? -1 : 1;
    append(steps, Kind::Scale, grf::Vec3f(grf::Vec3d(lengths(0), lengths(1), lengths(2)) * sign));
    append(steps, Kind::Rotation, angles_of(unit * sign));
    return;
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(linear, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d before = svd.matrixU();
  Eigen::Matrix3d after = svd.matrixV().transpose();
  double sign = 1;
  for (Eigen::Matrix3d* rotation : {&before, &after}) {
    if (rotation->determinant() > 0) continue;
    *rotation = -*rotation;
    sign = -sign;
  }
  const Eigen::Vector3d scale = sign * svd.singularValues();
  append(steps, Kind::Rotation, angles_of(before));
  append(steps, Kind::Scale, grf::Vec3f(grf::Vec3d(scale(0), scale(1), scale(2))));
  append(steps, Kind::Rotation, angles_of(after));
}

class MeshFilter {
 public:
  explicit MeshFilter(const std::function<bool(const grf::Mesh&)>& keeps) : keeps_(keeps) {}

  void run(grf::BlockList& list) {
    std::vector<grf::Block> kept;
    for (grf::Block& block : list.blocks) {
      if (!keeps(block)) continue;
      auto* scope = std::get_if<grf::DefinitionScope>(&block.content);
      if (scope == nullptr || !scope->definitions.empty()) {
        kept.push_back(std::move(block));
        continue;
      }
      auto& inside = scope->body.blocks;  // a scope has definitions
      std::move(inside.begin(), inside.end(), std::back_inserter(kept));
    }
    list.blocks = std::move(kept);
  }

 private:
  bool keeps(grf::Block& block) {
    if (const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&block.content)) return keeps_(**mesh);
    if (const auto* light = std::get_if<grf::MeshLight>(&block.content)) return keeps_(*light->mesh);
    if (const auto* use = std::get_if<grf::Use>(&block.content)) return !removed_.contains(use->mesh.name);
    if (auto* transform = std::get_if<grf::Transform>(&block.content)) {
      run(transform->body);
      return !transform->body.blocks.empty();
    }
    if (auto* scope = std::get_if<grf::DefinitionScope>(&block.content)) filter(*scope);
    return true;
  }

  void filter(grf::DefinitionScope& scope) {
    const std::set<std::string> outside = removed_;  // whose names may be defined again in the scope
    for (const grf::Definition& definition : scope.definitions) removed_.erase(definition.name);
    std::erase_if(scope.definitions, [this](const grf::Definition& definition) {
      const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body);
      const bool is_removed = mesh != nullptr && !keeps_(**mesh);
      if (is_removed) removed_.insert(definition.name);
      return is_removed;
    });
    run(scope.body);
    removed_ = outside;
  }

  const std::function<bool(const grf::Mesh&)>& keeps_;
  std::set<std::string> removed_;  ///< definitions in scope
};

}  // namespace

grf::Scene scene_of(std::vector<grf::Definition> definitions, std::vector<grf::Block> blocks,
                    const grf::SourceLocation& location) {
  grf::Scene scene;
  if (definitions.empty()) {
    scene.contents.blocks = std::move(blocks);
    return scene;
  }
  grf::DefinitionScope scope;
  scope.definitions = std::move(definitions);
  scope.body.blocks = std::move(blocks);
  grf::Block block;
  block.content = std::move(scope);
  block.location = location;
  scene.contents.blocks.push_back(std::move(block));
  return scene;
}

std::vector<grf::Block> placed(std::vector<grf::Block> blocks, const Matrix44d& to_parent,
                               const grf::SourceLocation& location) {
  grf::Transform transform;
  transform.steps = transform_steps(to_parent);
  if (transform.steps.empty() || blocks.empty()) return blocks;
  transform.body.blocks = std::move(blocks);
  grf::Block block;
  block.content = std::move(transform);
  block.location = location;
  std::vector<grf::Block> one;  // {block} would make a deep copy
  one.push_back(std::move(block));
  return one;
}

std::vector<grf::TransformStep> transform_steps(const Matrix44d& matrix) {
  std::vector<grf::TransformStep> steps;
  append_linear_part(steps, matrix);
  append(steps, Kind::Translation, grf::Vec3f(matrix.translation()));
  return steps;
}

grf::Box3d bounds_of(const grf::Scene& scene) {
  grf::Box3d bounds;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    bounds.extendBy(mesh.geometry.vertices().bounds_under(placement.to_world));
  };
  grf::visit(scene, visitor);
  return bounds;
}

void for_each_mesh(grf::BlockList& list, const std::function<void(grf::Shared<grf::Mesh>&)>& action) {
  for (grf::Block& block : list.blocks) {
    if (auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&block.content)) action(*mesh);
    if (auto* light = std::get_if<grf::MeshLight>(&block.content)) action(light->mesh);
    if (auto* transform = std::get_if<grf::Transform>(&block.content)) for_each_mesh(transform->body, action);
    auto* scope = std::get_if<grf::DefinitionScope>(&block.content);
    if (scope == nullptr) continue;
    for (grf::Definition& definition : scope->definitions) {
      if (auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body)) action(*mesh);
    }
    for_each_mesh(scope->body, action);
  }
}

void keep_meshes(grf::BlockList& list, const std::function<bool(const grf::Mesh&)>& keeps) {
  MeshFilter(keeps).run(list);
}

std::string name_of_file(const std::string& path) {
  std::string name = to_utf8(std::filesystem::path(path).stem().string());
  const auto is_control = [](unsigned char letter) { return letter < ' ' || letter == 127; };
  std::replace_if(name.begin(), name.end(), is_control, ' ');
  return grf::with_one_kind_of_quotes(std::move(name));
}

void name_meshes(grf::Scene& scene, const std::string& path) {
  grf::UniqueNames names;
  for_each_mesh(scene.contents, [&](const grf::Shared<grf::Mesh>& mesh) { names.add(mesh->name); });
  const std::string name = name_of_file(path);
  for_each_mesh(scene.contents, [&](grf::Shared<grf::Mesh>& mesh) {
    if (mesh->name.empty()) mesh.edit().name = names.take(name);
  });
}

std::string DefinitionNames::take(std::string_view name) { return names_.take(grf::to_identifier(name)); }

}  // namespace convert
