#include "tests/stability/naive_tracer.h"

#include <cmath>

namespace test {

using transport::Vec3f;

std::optional<NaiveTracer::Hit> NaiveTracer::intersect(const Vec3f& origin, const Vec3f& direction) const {
  std::optional<Hit> found;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const auto& [a, b, c] = triangles_[i];
    const Vec3f ab = b - a;
    const Vec3f ac = c - a;
    const Vec3f p = direction.cross(ac);
    const float determinant = ab.dot(p);
    if (std::abs(determinant) < least_determinant_) continue;
    const Vec3f from_a = origin - a;
    const float u = from_a.dot(p) / determinant;
    if (u < 0 || u > 1) continue;
    const Vec3f q = from_a.cross(ab);
    const float v = direction.dot(q) / determinant;
    if (v < 0 || u + v > 1) continue;
    const float distance = ac.dot(q) / determinant;
    if (distance <= nearest_ || (found && distance >= found->distance)) continue;
    found = Hit{i, distance, ab.cross(ac).normalized()};
  }
  return found;
}

std::vector<NaiveTracer::Corners> triangles_of(const transport::Geometry& geometry, const Vec3f& offset) {
  const transport::TriangleMesh& mesh = geometry.meshes[0];
  std::vector<NaiveTracer::Corners> triangles;
  for (const transport::Triangle& triangle : mesh.triangles) {
    NaiveTracer::Corners corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.positions[triangle.corners[i]] + offset;
    triangles.push_back(corners);
  }
  return triangles;
}

}  // namespace test
