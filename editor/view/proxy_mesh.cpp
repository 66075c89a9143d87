#include "editor/view/proxy_mesh.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace editor {
namespace {

using grf::Vec3d;
using grf::Vec3f;

double area_of(const TriangleArrays& arrays) {
  double doubled = 0;
  for (const auto& [a, b, c] : arrays.triangles) {
    const Vec3d origin(arrays.positions[a]);
    doubled += (Vec3d(arrays.positions[b]) - origin).cross(Vec3d(arrays.positions[c]) - origin).length();
  }
  return doubled / 2;
}

void copy_vertex(const TriangleArrays& from, std::uint32_t vertex, TriangleArrays& to) {
  to.positions.push_back(from.positions[vertex]);
  to.normals.push_back(from.normals[vertex]);
  if (!from.colours.empty()) to.colours.push_back(from.colours[vertex]);
  if (!from.irradiance.empty()) to.irradiance.push_back(from.irradiance[vertex]);
  if (!from.uvs.empty()) to.uvs.push_back(from.uvs[vertex]);
}

/// The grid cells of vertices, numbered in order of first use.
class Clusters {
 public:
  Clusters(const TriangleArrays& arrays, const Vec3f& origin, float cell) : origin_(origin), cell_(cell) {
    cluster_of_.reserve(arrays.positions.size());
    for (const Vec3f& position : arrays.positions) {
      const auto [entry, is_new] = numbers_.try_emplace(key_of(position), first_.size());
      const auto number = static_cast<std::uint32_t>(entry->second);
      if (is_new) first_.push_back(static_cast<std::uint32_t>(cluster_of_.size()));
      cluster_of_.push_back(number);
    }
  }

  std::uint32_t of(std::uint32_t vertex) const { return cluster_of_[vertex]; }
  /// The first vertex of each cell.
  const std::vector<std::uint32_t>& first() const { return first_; }

 private:
  std::uint64_t key_of(const Vec3f& position) const {
    const auto step = [this](float x, float from) {
      return static_cast<std::uint64_t>(std::max(0.0F, std::floor((x - from) / cell_))) & 0x1fffff;
    };
    return step(position.x, origin_.x) | step(position.y, origin_.y) << 21 |
           step(position.z, origin_.z) << 42;
  }

  Vec3f origin_;
  float cell_;
  std::unordered_map<std::uint64_t, std::size_t> numbers_;
  std::vector<std::uint32_t> cluster_of_;
  std::vector<std::uint32_t> first_;
};

/// Places vertices at the mean of those that they represent.
void place_vertices(const TriangleArrays& arrays, const Clusters& clusters, TriangleArrays& result) {
  for (const std::uint32_t vertex : clusters.first()) copy_vertex(arrays, vertex, result);
  std::vector<Vec3d> sums(result.positions.size(), Vec3d(0));
  std::vector<Imath::V4f> normals(result.positions.size(), Imath::V4f(0));
  std::vector<std::uint32_t> counts(result.positions.size());
  for (std::uint32_t i = 0; i < arrays.positions.size(); ++i) {
    const std::uint32_t cluster = clusters.of(i);
    sums[cluster] += Vec3d(arrays.positions[i]);
    normals[cluster] += arrays.normals[i];
    ++counts[cluster];
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    result.positions[i] = Vec3f(sums[i] / counts[i]);
    // Both sides of a thin sheet in one cell cancel each other: then the first normal is used.
    const Vec3f mean(normals[i].x, normals[i].y, normals[i].z);
    const bool all_have_one = normals[i].w == static_cast<float>(counts[i]);
    if (!all_have_one || mean.length() < 0.1F * normals[i].w) continue;
    const Vec3f unit = mean.normalized();
    result.normals[i] = {unit.x, unit.y, unit.z, 1};
  }
}

TriangleArrays clustered(const TriangleArrays& arrays, const grf::Box3f& box, double cell) {
  const Clusters clusters(arrays, box.min, static_cast<float>(cell));
  TriangleArrays result;
  place_vertices(arrays, clusters, result);
  for (std::size_t i = 0; i < arrays.triangles.size(); ++i) {
    const auto& [a, b, c] = arrays.triangles[i];
    const TriangleArrays::Triangle triangle = {clusters.of(a), clusters.of(b), clusters.of(c)};
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
    result.triangles.push_back(triangle);
    result.face_of_triangle.push_back(arrays.face_of_triangle[i]);
  }
  return result;
}

}  // namespace

TriangleArrays make_proxy_mesh(const TriangleArrays& arrays, std::size_t triangles) {
  if (arrays.triangles.size() <= triangles) return arrays;
  grf::Box3f box;
  for (const Vec3f& position : arrays.positions) box.extendBy(position);
  // A surface intersects about 1.5 cells per cell area, and leaves two triangles in each.
  double cell = std::sqrt(3 * area_of(arrays) / static_cast<double>(triangles));
  cell = std::max(cell, 1e-6 * (box.max - box.min).length());
  TriangleArrays result = clustered(arrays, box, cell);
  // Crumpled surfaces have more.
  for (int tries = 0; result.triangles.size() > triangles * 3 / 2 && tries < 3; ++tries) {
    cell *= std::sqrt(static_cast<double>(result.triangles.size()) / static_cast<double>(triangles));
    result = clustered(arrays, box, cell);
  }
  return result.triangles.empty() ? subsampled(arrays, triangles) : result;
}

TriangleArrays subsampled(const TriangleArrays& arrays, std::size_t triangles) {
  TriangleArrays result;
  const std::size_t step = (arrays.triangles.size() + triangles - 1) / std::max<std::size_t>(triangles, 1);
  for (std::size_t i = 0; i < arrays.triangles.size(); i += std::max<std::size_t>(step, 1)) {
    const auto first = static_cast<std::uint32_t>(result.positions.size());
    for (const std::uint32_t corner : arrays.triangles[i]) copy_vertex(arrays, corner, result);
    result.triangles.push_back({first, first + 1, first + 2});
    result.face_of_triangle.push_back(arrays.face_of_triangle[i]);
  }
  return result;
}

}  // namespace editor
