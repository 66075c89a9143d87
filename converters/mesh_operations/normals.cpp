#include "converters/mesh_operations/normals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <unordered_map>
#include <vector>

#include "converters/mesh_operations/rebuild.h"
#include "grf/topology.h"

namespace convert {
namespace {

grf::Mesh without_normals(const grf::Mesh& mesh) {
  grf::MeshDraft bare(mesh);
  bare.normals = {};
  return bare;
}

/// Zero for a face without area.
std::vector<grf::Vec3d> face_normals(const grf::Geometry& geometry) {
  std::vector<grf::Vec3d> normals;
  normals.reserve(geometry.face_count());
  for (std::size_t face = 0; face < geometry.face_count(); ++face) {
    normals.push_back(grf::doubled_area_vector(geometry, face, grf::Matrix44d()).normalized());
  }
  return normals;
}

double angle_between(const grf::Vec3d& a, const grf::Vec3d& b) {
  return std::atan2(a.cross(b).length(), a.dot(b));
}

bool is_smooth(const grf::Vec3d& normal_a, const grf::Vec3d& normal_b, double crease) {
  // Rounding must not make a crease of the angle that was asked for.
  constexpr double Rounding = 1e-6;
  return normal_a.length2() > 0 && normal_b.length2() > 0 &&
         angle_between(normal_a, normal_b) <= crease + Rounding;
}

/// An edge of more faces is no part of a surface, and to compare all with all would take too long.
constexpr std::size_t MostCompared = 16;

/// The corners that are to have one normal.
grf::CornerSets smooth_sets(const grf::Geometry& geometry, const std::vector<grf::Vec3d>& normals,
                            double crease) {
  const std::vector<std::uint32_t> places = grf::first_at_place(geometry);
  const std::vector<grf::FaceEdge> edges = grf::edges_of_faces(geometry, places);
  grf::CornerSets sets(geometry.corners.size());
  grf::for_each_edge(edges, [&](std::span<const grf::FaceEdge> of_faces) {
    for (std::size_t i = 0; i < of_faces.size(); ++i) {
      const std::size_t end = std::min(of_faces.size(), i + 1 + MostCompared);
      for (std::size_t k = i + 1; k < end; ++k) {
        const bool joins = is_smooth(normals[of_faces[i].face], normals[of_faces[k].face], crease);
        if (joins) sets.join_at_edge(geometry, places, of_faces[i], of_faces[k]);
      }
    }
  });
  return sets;
}

/// For each set, at the corner that stands for it, the sum of its faces' weighted normals.
std::vector<grf::Vec3d> weighted_sums(const grf::Geometry& geometry, const std::vector<grf::Vec3d>& normals,
                                      grf::CornerSets& sets) {
  std::vector<grf::Vec3d> sums(geometry.corners.size(), grf::Vec3d(0));
  for (std::size_t face = 0; face < geometry.face_count(); ++face) {
    const auto corners = geometry.face(face);
    const std::size_t n = corners.size();
    for (std::size_t k = 0; k < n; ++k) {
      const grf::Vec3d here(geometry.positions[corners[k]]);
      const grf::Vec3d next = grf::Vec3d(geometry.positions[corners[(k + 1) % n]]) - here;
      const grf::Vec3d previous = grf::Vec3d(geometry.positions[corners[(k + n - 1) % n]]) - here;
      const auto corner = static_cast<std::uint32_t>(geometry.face_offsets[face] + k);
      sums[sets.set_of(corner)] += angle_between(next, previous) * normals[face];
    }
  }
  return sums;
}

}  // namespace

grf::Mesh with_flat_faces(const grf::Mesh& mesh) {
  const grf::Mesh bare = without_normals(mesh);
  const std::vector<std::uint32_t> alike = first_alike(bare);
  Rebuild rebuild(bare);
  std::vector<std::uint32_t> corners;
  for (std::size_t face = 0; face < bare.face_count(); ++face) {
    corners.clear();
    for (const std::uint32_t corner : bare.face(face)) corners.push_back(alike[corner]);
    rebuild.add_face(corners, (*bare.surface_of_face)[face]);
  }
  return rebuild.take();
}

grf::Mesh with_smooth_normals(const grf::Mesh& mesh, double crease) {
  const grf::Mesh bare = without_normals(mesh);
  const std::vector<std::uint32_t> alike = first_alike(bare);
  const std::vector<grf::Vec3d> normals = face_normals(*bare.geometry);
  grf::CornerSets sets = smooth_sets(*bare.geometry, normals, crease);
  const std::vector<grf::Vec3d> sums = weighted_sums(*bare.geometry, normals, sets);

  const grf::Geometry& geometry = *bare.geometry;
  grf::MeshDraft result = without_geometry(bare);
  std::unordered_map<std::uint64_t, std::uint32_t> vertices;  // by what they are like, and their set
  std::vector<std::uint32_t> corners;
  for (std::uint32_t face = 0; face < bare.face_count(); ++face) {
    corners.clear();
    for (std::uint32_t corner = geometry.face_offsets[face]; corner < geometry.face_offsets[face + 1];
         ++corner) {
      const std::uint32_t vertex = alike[geometry.corners[corner]];
      const std::uint32_t set = sets.set_of(corner);
      const auto next = static_cast<std::uint32_t>(result.positions.size());
      const auto [known, is_new] = vertices.emplace(std::uint64_t(vertex) << 32U | set, next);
      corners.push_back(known->second);
      if (!is_new) continue;
      result.copy_vertex(bare, vertex);
      if (sums[set].length2() > 0) result.normals.set(next, grf::Vec3f(sums[set].normalized()));
    }
    result.add_face(corners, (*bare.surface_of_face)[face]);
  }
  result.free_spare_memory();
  return result;
}

}  // namespace convert
