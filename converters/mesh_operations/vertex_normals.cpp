#include "converters/mesh_operations/vertex_normals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "grf/topology.h"

namespace convert {
namespace {

double angle_between(const grf::Vec3d& a, const grf::Vec3d& b) {
  return std::atan2(a.cross(b).length(), a.dot(b));
}

/// Calls a function with the inner angle at each corner, which is over pi at a reflex corner.
template <class Action>
void for_each_angle(std::span<const std::uint32_t> face, std::span<const grf::Vec3f> positions,
                    const grf::Vec3d& normal, const Action& action) {
  const std::size_t n = face.size();
  for (std::size_t k = 0; k < n; ++k) {
    const grf::Vec3d here(positions[face[k]]);
    const grf::Vec3d next = grf::Vec3d(positions[face[(k + 1) % n]]) - here;
    const grf::Vec3d previous = grf::Vec3d(positions[face[(k + n - 1) % n]]) - here;
    const double angle = angle_between(next, previous);
    // A triangle can only seem reflex by rounding.
    const bool is_reflex = n > 3 && next.cross(previous).dot(normal) < 0;
    action(k, is_reflex ? 2 * std::numbers::pi - angle : angle);
  }
}

/// The maximum number of faces per edge that are compared: comparing all pairs would be quadratic.
constexpr std::size_t MostCompared = 16;

grf::DisjointSets smooth_corners(const grf::Geometry& geometry, std::span<const std::uint32_t> places,
                                 const std::vector<grf::Vec3d>& normals, double crease) {
  const auto is_smooth = [&](const grf::HalfEdge& a, const grf::HalfEdge& b) {
    const grf::Vec3d& normal_a = normals[a.face];
    const grf::Vec3d& normal_b = normals[b.face];
    return normal_a.length2() > 0 && normal_b.length2() > 0 && angle_between(normal_a, normal_b) <= crease;
  };
  grf::DisjointSets corners(geometry.corners.size());
  grf::for_each_edge(grf::half_edges_of(geometry, places), [&](std::span<const grf::HalfEdge> of_faces) {
    for (std::size_t i = 0; i < of_faces.size(); ++i) {
      const std::size_t end = std::min(of_faces.size(), i + 1 + MostCompared);
      for (std::size_t k = i + 1; k < end; ++k) {
        if (is_smooth(of_faces[i], of_faces[k])) {
          grf::join_at_edge(corners, geometry, places, of_faces[i], of_faces[k]);
        }
      }
    }
  });
  return corners;
}

}  // namespace

void weighted_normals(std::span<const std::uint32_t> face, std::span<const grf::Vec3f> positions,
                      std::vector<grf::Vec3d>& normals) {
  const grf::Vec3d normal = grf::doubled_area_vector(face, positions).normalized();
  normals.resize(face.size());
  for_each_angle(face, positions, normal, [&](std::size_t k, double angle) { normals[k] = angle * normal; });
}

std::optional<grf::Vec3f> unit_normal(const grf::Vec3d& sum) {
  constexpr double Cancelled = 1e-9;  // the rounding error for faces that are back to back
  return sum.length() > Cancelled ? std::optional(grf::Vec3f(sum.normalized())) : std::nullopt;
}

CreasedNormals creased_normals(const grf::Geometry& geometry, std::span<const std::uint32_t> places,
                               double crease) {
  std::vector<grf::Vec3d> face_normals;
  face_normals.reserve(geometry.face_count());
  for (std::size_t face = 0; face < geometry.face_count(); ++face) {
    face_normals.push_back(grf::doubled_area_vector(geometry.face(face), geometry.positions).normalized());
  }
  CreasedNormals normals{smooth_corners(geometry, places, face_normals, crease),
                         std::vector<grf::Vec3d>(geometry.corners.size(), grf::Vec3d(0))};
  for (std::size_t face = 0; face < geometry.face_count(); ++face) {
    const grf::Vec3d& normal = face_normals[face];
    for_each_angle(geometry.face(face), geometry.positions, normal, [&](std::size_t k, double angle) {
      const auto corner = static_cast<std::uint32_t>(geometry.face_offsets[face] + k);
      normals.sums[normals.corners.set_of(corner)] += angle * normal;
    });
  }
  return normals;
}

}  // namespace convert
