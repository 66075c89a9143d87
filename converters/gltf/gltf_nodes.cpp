#include "converters/gltf/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "converters/wording.h"

namespace convert {
namespace {

using grf::Matrix44d;
using grf::Vec3d;

bool is_finite(const Matrix44d& matrix) {
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      if (!std::isfinite(matrix[i][k])) return false;
    }
  }
  return true;
}

// glTF's matrices are column-major for column vectors, so that the numbers are in the same order for row
// vectors.
template <class Numbers>
Matrix44d matrix_of(const Numbers& numbers) {
  Matrix44d matrix;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k)
      matrix[i][k] = numbers[4 * static_cast<std::size_t>(i) + static_cast<std::size_t>(k)];
  }
  return matrix;
}

/// Converts a non-zero quaternion of any length to a matrix.
Matrix44d rotation_of(const std::vector<double>& q) {
  const double squared = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  Matrix44d matrix;
  if (squared == 0) return matrix;
  const double s = 2 / squared;
  const double x = q[0];
  const double y = q[1];
  const double z = q[2];
  const double w = q[3];
  matrix[0][0] = 1 - s * (y * y + z * z);
  matrix[0][1] = s * (x * y + z * w);
  matrix[0][2] = s * (x * z - y * w);
  matrix[1][0] = s * (x * y - z * w);
  matrix[1][1] = 1 - s * (x * x + z * z);
  matrix[1][2] = s * (y * z + x * w);
  matrix[2][0] = s * (x * z + y * w);
  matrix[2][1] = s * (y * z - x * w);
  matrix[2][2] = 1 - s * (x * x + y * y);
  return matrix;
}

/// Returns the transform of a node; nothing if an array has a wrong length.
std::optional<Matrix44d> local_matrix(const tinygltf::Node& node) {
  const auto has_length = [](const std::vector<double>& values, std::size_t length) {
    return values.empty() || values.size() == length;
  };
  const bool fits = has_length(node.matrix, 16) && has_length(node.translation, 3) &&
                    has_length(node.rotation, 4) && has_length(node.scale, 3);
  if (!fits) return std::nullopt;
  if (!node.matrix.empty()) return matrix_of(node.matrix);
  Matrix44d matrix;
  if (!node.scale.empty()) matrix.setScale(Vec3d(node.scale[0], node.scale[1], node.scale[2]));
  if (!node.rotation.empty()) matrix *= rotation_of(node.rotation);
  if (!node.translation.empty()) {
    for (int i = 0; i < 3; ++i) matrix[3][i] = node.translation[static_cast<std::size_t>(i)];
  }
  return matrix;
}

bool is_affine(const Matrix44d& m) { return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1; }

}  // namespace

bool GltfNodes::load() { return find_parents() && find_roots() && find_transforms(); }

bool GltfNodes::find_parents() {
  const auto& nodes = file_.model.nodes;
  parents_.assign(nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const int child : nodes[i].children) {
      if (!exists(child)) return accessors_.fail(fmt::format("there is no node {}", child)), false;
      int& parent = parents_[static_cast<std::size_t>(child)];
      if (parent >= 0) return accessors_.fail(fmt::format("node {} has two parents", child)), false;
      parent = static_cast<int>(i);
    }
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    int depth = 0;
    for (int node = static_cast<int>(i); node >= 0; node = parents_[static_cast<std::size_t>(node)]) {
      if (++depth > Deepest) {
        accessors_.fail(fmt::format("node {} is its own ancestor, or is nested deeper than {}", i, Deepest));
        return false;
      }
    }
  }
  return true;
}

bool GltfNodes::find_roots() {
  const tinygltf::Model& model = file_.model;
  if (model.scenes.empty()) {
    for (std::size_t i = 0; i < parents_.size(); ++i) {
      if (parents_[i] < 0) roots_.push_back(static_cast<int>(i));
    }
    return true;
  }
  const auto scene = static_cast<std::size_t>(std::max(model.defaultScene, 0));
  if (scene >= model.scenes.size()) return accessors_.fail(fmt::format("there is no scene {}", scene)), false;
  roots_ = model.scenes[scene].nodes;
  for (const int root : roots_) {
    if (!exists(root)) return accessors_.fail(fmt::format("there is no node {}", root)), false;
  }
  std::sort(roots_.begin(), roots_.end());
  const bool twice = std::adjacent_find(roots_.begin(), roots_.end()) != roots_.end();
  if (twice) return accessors_.fail("a node is twice a root of its scene"), false;
  roots_ = model.scenes[scene].nodes;
  const auto is_child = [this](int node) { return parents_[static_cast<std::size_t>(node)] >= 0; };
  if (std::any_of(roots_.begin(), roots_.end(), is_child)) {
    return accessors_.fail("a node is a root of its scene, and a child of another node"), false;
  }
  return true;
}

bool GltfNodes::find_transforms() {
  const auto& nodes = file_.model.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto matrix = local_matrix(nodes[i]);
    if (!matrix || !is_finite(*matrix) || !is_affine(*matrix)) {
      return accessors_.fail(fmt::format("node {} has an invalid transform", i)), false;
    }
    to_parent_.push_back(*matrix);
  }
  return true;
}

Matrix44d GltfNodes::to_scene(int node) const {
  Matrix44d matrix = to_parent(node);
  while ((node = parents_[static_cast<std::size_t>(node)]) >= 0) matrix *= to_parent(node);
  return matrix;
}

std::optional<std::vector<Matrix44d>> GltfNodes::joints(int index) {
  const auto& skins = file_.model.skins;
  if (index < 0 || static_cast<std::size_t>(index) >= skins.size()) {
    return accessors_.fail(fmt::format("there is no skin {}", index));
  }
  const tinygltf::Skin& skin = skins[static_cast<std::size_t>(index)];
  std::vector<Matrix44d> joints;
  for (const int joint : skin.joints) {
    if (!exists(joint)) return accessors_.fail(fmt::format("there is no node {}", joint));
    joints.push_back(to_scene(joint));
  }
  if (joints.empty()) return accessors_.fail(fmt::format("skin {} has no joints", index));
  if (skin.inverseBindMatrices < 0) return joints;
  const auto numbers = accessors_.floats(skin.inverseBindMatrices, 16);
  if (!numbers) return std::nullopt;
  if (numbers->size() < 16 * joints.size()) {
    return accessors_.fail(fmt::format("skin {} has {}, and matrices for {}", index,
                                       counted(joints.size(), "joint", "joints"), numbers->size() / 16));
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    joints[i] = matrix_of(std::span(*numbers).subspan(16 * i, 16)) * joints[i];
  }
  return joints;
}

}  // namespace convert
