#include "renderer/transport/scene/geometry.h"

#include <algorithm>
#include <cmath>

namespace transport {
namespace {

using grf::Matrix33f;
using grf::Matrix44d;

template <class Value>
std::size_t bytes_of(const std::vector<Value>& values) {
  return values.capacity() * sizeof(Value);
}

Matrix33f linear_part(const Matrix44d& m) {
  const auto entry = [&](int i, int k) { return static_cast<float>(m[i][k]); };
  return {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 0), entry(1, 1),
          entry(1, 2), entry(2, 0), entry(2, 1), entry(2, 2)};
}

/// The factor by which mapping to an instance and back can amplify rounding errors: the largest row sum of
/// (|M| |M^-1|)^2, which bounds the error of the inverse too.
double condition(const Matrix44d& m) {
  const Matrix44d inverse = m.inverse();
  std::array<std::array<double, 3>, 3> product = {};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      for (int j = 0; j < 3; ++j) product[i][k] += std::abs(inverse[i][j]) * std::abs(m[j][k]);
    }
  }
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) sum += product[i][j] * product[j][k];
    }
    largest = std::max(largest, sum);
  }
  return largest;
}

bool have_same_shape(const TriangleMesh& a, const TriangleMesh& b) {
  const auto have_same_corners = [](const Triangle& one, const Triangle& other) {
    return one.corners == other.corners;
  };
  return a.has_cutouts == b.has_cutouts && a.positions == b.positions &&
         std::ranges::equal(a.triangles, b.triangles, have_same_corners);
}

}  // namespace

bool have_same_shape(const Geometry& a, const Geometry& b) {
  const auto are_meshes_same = [](const TriangleMesh& one, const TriangleMesh& other) {
    return have_same_shape(one, other);
  };
  const auto are_places_same = [](const Instance& one, const Instance& other) {
    return one.mesh == other.mesh && one.to_scene.linear == other.to_scene.linear &&
           one.to_scene.translation == other.to_scene.translation;
  };
  return std::ranges::equal(a.meshes, b.meshes, are_meshes_same) &&
         std::ranges::equal(a.instances, b.instances, are_places_same);
}

Instance::Instance(const Matrix44d& matrix) {
  to_scene.linear = linear_part(matrix);
  to_scene.translation = Vec3f(matrix.translation());
  normal_map = linear_part(matrix.inverse().transposed());
  // Two maps of points, of four products each, and the inverse that Embree computes in float.
  constexpr double RoundingErrors = 12 * 0x1p-24;
  error_factor = static_cast<float>(RoundingErrors * condition(matrix));
  const Vec3f& offset = to_scene.translation;
  error_extent = std::max({std::abs(offset.x), std::abs(offset.y), std::abs(offset.z)});
}

std::uint32_t TriangleMesh::emitting_number(std::uint32_t triangle) const {
  const auto after = std::upper_bound(
      emitting_runs.begin(), emitting_runs.end(), triangle,
      [](std::uint32_t value, const EmittingRun& run) { return value < run.first_triangle; });
  const EmittingRun& run = *(after - 1);
  return run.first_number + (triangle - run.first_triangle);
}

std::size_t TriangleMesh::bytes() const {
  return bytes_of(positions) + bytes_of(normals) + bytes_of(colours) + bytes_of(uvs) + bytes_of(irradiance) +
         bytes_of(triangles) + bytes_of(emitting_runs);
}

std::size_t Geometry::bytes() const {
  std::size_t bytes = bytes_of(instances) + bytes_of(emitter_table) + bytes_of(emitter_triangles);
  for (const TriangleMesh& mesh : meshes) bytes += sizeof(mesh) + mesh.bytes();
  return bytes;
}

}  // namespace transport
