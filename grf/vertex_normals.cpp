#include "grf/vertex_normals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "grf/topology.h"

namespace grf {
namespace {

double angle_between(const Vec3d& a, const Vec3d& b) { return std::atan2(a.cross(b).length(), a.dot(b)); }

/// Does something with the inner angle at each corner, which is over pi where a corner points inwards.
template <class Action>
void for_each_angle(std::span<const std::uint32_t> face, std::span<const Vec3f> positions,
                    const Vec3d& normal, const Action& action) {
  const std::size_t n = face.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3d here(positions[face[k]]);
    const Vec3d next = Vec3d(positions[face[(k + 1) % n]]) - here;
    const Vec3d previous = Vec3d(positions[face[(k + n - 1) % n]]) - here;
    const double angle = angle_between(next, previous);
    // Of a triangle only rounding can say so.
    const bool is_reflex = n > 3 && next.cross(previous).dot(normal) < 0;
    action(k, is_reflex ? 2 * std::numbers::pi - angle : angle);
  }
}

/// An edge of more faces is no part of a surface, and to compare all with all would take too long.
constexpr std::size_t MostCompared = 16;

DisjointSets smooth_corners(const Geometry& geometry, std::span<const std::uint32_t> places,
                            const std::vector<Vec3d>& normals, double crease) {
  const auto is_smooth = [&](const FaceEdge& a, const FaceEdge& b) {
    const Vec3d& normal_a = normals[a.face];
    const Vec3d& normal_b = normals[b.face];
    return normal_a.length2() > 0 && normal_b.length2() > 0 && angle_between(normal_a, normal_b) <= crease;
  };
  DisjointSets corners(geometry.corners.size());
  for_each_edge(edges_of_faces(geometry, places), [&](std::span<const FaceEdge> of_faces) {
    for (std::size_t i = 0; i < of_faces.size(); ++i) {
      const std::size_t end = std::min(of_faces.size(), i + 1 + MostCompared);
      for (std::size_t k = i + 1; k < end; ++k) {
        if (is_smooth(of_faces[i], of_faces[k])) {
          join_at_edge(corners, geometry, places, of_faces[i], of_faces[k]);
        }
      }
    }
  });
  return corners;
}

}  // namespace

void weighted_normals(std::span<const std::uint32_t> face, std::span<const Vec3f> positions,
                      std::vector<Vec3d>& normals) {
  const Vec3d normal = doubled_area_vector(face, positions).normalized();
  normals.resize(face.size());
  for_each_angle(face, positions, normal, [&](std::size_t k, double angle) { normals[k] = angle * normal; });
}

std::optional<Vec3f> unit_normal(const Vec3d& sum) {
  constexpr double Cancelled = 1e-9;  // what rounding leaves of faces that are back to back
  return sum.length() > Cancelled ? std::optional(Vec3f(sum.normalized())) : std::nullopt;
}

CreasedNormals creased_normals(const Geometry& geometry, std::span<const std::uint32_t> places,
                               double crease) {
  std::vector<Vec3d> face_normals;
  face_normals.reserve(geometry.face_count());
  for (std::size_t face = 0; face < geometry.face_count(); ++face) {
    face_normals.push_back(doubled_area_vector(geometry.face(face), geometry.positions).normalized());
  }
  CreasedNormals normals{smooth_corners(geometry, places, face_normals, crease),
                         std::vector<Vec3d>(geometry.corners.size(), Vec3d(0))};
  for (std::size_t face = 0; face < geometry.face_count(); ++face) {
    const Vec3d& normal = face_normals[face];
    for_each_angle(geometry.face(face), geometry.positions, normal, [&](std::size_t k, double angle) {
      const auto corner = static_cast<std::uint32_t>(geometry.face_offsets[face] + k);
      normals.sums[normals.corners.set_of(corner)] += angle * normal;
    });
  }
  return normals;
}

}  // namespace grf
