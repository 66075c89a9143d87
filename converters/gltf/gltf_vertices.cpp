#include "converters/gltf/gltf_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "converters/wording.h"

namespace convert {
namespace {

using Four = std::array<float, 4>;
using grf::Matrix44d;
using grf::Vec3d;
using grf::Vec3f;

class VertexReader {
 public:
  VertexReader(const GltfVertexSource& source, const GltfPose& pose, GltfAccessors& accessors, Losses& losses)
      : source_(source), pose_(pose), accessors_(accessors), losses_(losses) {}

  std::optional<GltfVertices> run() {
    const int positions = attribute("POSITION");
    if (positions < 0) return accessors_.fail("a primitive has no positions");
    if (!take(accessors_.vectors<Vec3f>(positions), vertices_.positions)) return std::nullopt;
    const bool read =
        read_normals() && read_colours() && read_uvs() && morph() && pose_by_skin() && is_in_range();
    if (!read) return std::nullopt;
    count_losses();
    return std::move(vertices_);
  }

 private:
  std::size_t size() const { return vertices_.positions.size(); }

  int attribute(const std::string& name) const { return named(source_.attributes, name); }
  static int named(const std::map<std::string, int>& attributes, const std::string& name) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? -1 : found->second;
  }

  template <class Values>
  static bool take(std::optional<Values> values, Values& place) {
    if (!values) return false;
    place = std::move(*values);
    return true;
  }

  /// Returns whether there is a value per vertex; otherwise reports an error.
  bool fits(const std::string& name, int accessor) {
    const std::size_t count = accessors_.count(accessor);
    if (count == size()) return true;
    accessors_.fail(fmt::format("{} has {} for {}", name, counted(count, "value", "values"),
                                counted(size(), "vertex", "vertices")));
    return false;
  }

  template <class Vector>
  bool read(const std::string& name, int accessor, std::vector<Vector>& values, bool infinite = false) {
    return fits(name, accessor) && take(accessors_.vectors<Vector>(accessor, infinite), values);
  }

  // Zero normals are handled when the mesh is built.
  bool read_normals() {
    const int accessor = attribute("NORMAL");
    return accessor < 0 || read("NORMAL", accessor, vertices_.normals, true);
  }

  bool read_colours() {
    const int accessor = attribute("COLOR_0");
    if (accessor < 0) return true;
    if (!accessors_.has_components(accessor, 4)) return read("COLOR_0", accessor, vertices_.colours);
    std::vector<Four> values;
    if (!read("COLOR_0", accessor, values)) return false;
    vertices_.colours.reserve(size());
    for (const Four& value : values) {
      vertices_.colours.emplace_back(value[0], value[1], value[2]);
      if (value[3] < 1) ++transparent_;
    }
    return true;
  }

  bool read_uvs() {
    const std::string name = fmt::format("TEXCOORD_{}", source_.lookup.set);
    const int accessor = attribute(name);
    return accessor < 0 || read(name, accessor, vertices_.uvs);
  }

  // Section 3.7.2.2: morphed attributes are the sum of the base and of the weighted displacements.
  bool morph() {
    for (std::size_t i = 0; i < source_.targets.size() && i < pose_.weights.size(); ++i) {
      const auto weight = static_cast<float>(pose_.weights[i]);
      if (weight == 0) continue;
      const bool added = add("POSITION", i, weight, vertices_.positions) &&
                         add("NORMAL", i, weight, vertices_.normals) &&
                         add("COLOR_0", i, weight, vertices_.colours) &&
                         add(fmt::format("TEXCOORD_{}", source_.lookup.set), i, weight, vertices_.uvs);
      if (!added) return false;
    }
    finish_uvs();
    for (grf::Colour& colour : vertices_.colours) {
      for (int i = 0; i < 3; ++i) colour[i] = std::max(colour[i], 0.0F);
    }
    return true;
  }

  template <class Vector>
  bool add(const std::string& name, std::size_t target, float weight, std::vector<Vector>& values) {
    const int accessor = named(source_.targets[target], name);
    if (accessor < 0 || values.empty()) return true;
    std::vector<Vector> differences;
    if (!accessors_.has_components(accessor, sizeof(Vector) / sizeof(float))) return true;  // RGBA
    if (!read(name, accessor, differences)) return false;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += differences[i] * weight;
    return true;
  }

  // Applies KHR_texture_transform, and flips v, which points down in glTF.
  void finish_uvs() {
    const TextureLookup& lookup = source_.lookup;
    const double c = std::cos(lookup.rotation);
    const double s = std::sin(lookup.rotation);
    const bool is_moved = lookup != TextureLookup{lookup.set};
    for (grf::Vec2f& uv : vertices_.uvs) {
      if (is_moved) {
        const double x = lookup.scale[0] * uv.x;
        const double y = lookup.scale[1] * uv.y;
        uv = grf::Vec2f(static_cast<float>(c * x + s * y + lookup.offset[0]),
                        static_cast<float>(c * y - s * x + lookup.offset[1]));
      }
      uv.y = 1 - uv.y;
    }
  }

  bool pose_by_skin() {
    if (pose_.joints.empty()) return true;
    std::vector<Matrix44d> sums(size(), Matrix44d(0.0));
    std::vector<double> weights(size());
    for (int set = 0; attribute(fmt::format("JOINTS_{}", set)) >= 0; ++set) {
      if (!add_joints(set, sums, weights)) return false;
    }
    for (std::size_t i = 0; i < size(); ++i) {
      if (weights[i] > 0) move(i, sums[i] * (1 / weights[i]));
    }
    return true;
  }

  bool add_joints(int set, std::vector<Matrix44d>& sums, std::vector<double>& weights) {
    const int joints_accessor = attribute(fmt::format("JOINTS_{}", set));
    const int weights_accessor = attribute(fmt::format("WEIGHTS_{}", set));
    std::vector<Four> joints;
    std::vector<Four> joint_weights;
    const bool read_both =
        read("JOINTS", joints_accessor, joints) && read("WEIGHTS", weights_accessor, joint_weights);
    if (!read_both) return false;
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        const double weight = joint_weights[i][k];
        if (weight <= 0) continue;
        if (!(joints[i][k] >= 0 && joints[i][k] < static_cast<float>(pose_.joints.size()))) {
          accessors_.fail(
              fmt::format("vertex {} follows joint {} of {}", i, joints[i][k], pose_.joints.size()));
          return false;
        }
        sums[i] += pose_.joints[static_cast<std::size_t>(joints[i][k])] * weight;
        weights[i] += weight;
      }
    }
    return true;
  }

  // Normals transform by the inverse transpose, which the cofactor matrix is up to a factor, without an
  // inverse.
  void move(std::size_t vertex, const Matrix44d& matrix) {
    Vec3d position;
    matrix.multVecMatrix(Vec3d(vertices_.positions[vertex]), position);
    vertices_.positions[vertex] = Vec3f(position);
    if (vertices_.normals.empty()) return;
    const Vec3d x(matrix[0][0], matrix[0][1], matrix[0][2]);
    const Vec3d y(matrix[1][0], matrix[1][1], matrix[1][2]);
    const Vec3d z(matrix[2][0], matrix[2][1], matrix[2][2]);
    const Vec3d normal(vertices_.normals[vertex]);
    const Vec3d moved = y.cross(z) * normal.x + z.cross(x) * normal.y + x.cross(y) * normal.z;
    vertices_.normals[vertex] = Vec3f(moved.normalized());
  }

  // Input values are finite, but sums and products of them may overflow.
  bool is_in_range() {
    if (are_finite(vertices_.positions) && are_finite(vertices_.colours) && are_finite(vertices_.uvs))
      return true;
    accessors_.fail("morph targets, joints or a texture's transform make values that are infinite");
    return false;
  }

  template <class Vector>
  static bool are_finite(const std::vector<Vector>& values) {
    return std::all_of(values.begin(), values.end(), [](const Vector& value) {
      for (unsigned i = 0; i < Vector::dimensions(); ++i) {
        if (!std::isfinite(value[static_cast<int>(i)])) return false;
      }
      return true;
    });
  }

  void count_losses() {
    losses_.add(Loss::Alpha, transparent_);
    for (const auto& [name, accessor] : source_.attributes) {
      if (name.starts_with('_')) losses_.add(Loss::VertexValues, size());
    }
  }

  const GltfVertexSource& source_;
  const GltfPose& pose_;
  GltfAccessors& accessors_;
  Losses& losses_;
  GltfVertices vertices_;
  std::size_t transparent_ = 0;
};

}  // namespace

std::optional<GltfVertices> read_vertices(const GltfVertexSource& source, const GltfPose& pose,
                                          GltfAccessors& accessors, Losses& losses) {
  return VertexReader(source, pose, accessors, losses).run();
}

}  // namespace convert
