#include "converters/mesh_operations/normals.h"

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "converters/mesh_operations/rebuild.h"
#include "converters/mesh_operations/vertex_normals.h"
#include "grf/topology.h"

namespace convert {
namespace {

grf::Mesh without_normals(const grf::Mesh& mesh) {
  grf::MeshDraft bare(mesh);
  bare.normals = {};
  return bare;
}

}  // namespace

grf::Mesh with_flat_faces(const grf::Mesh& mesh) {
  const grf::Mesh bare = without_normals(mesh);
  const std::vector<std::uint32_t> alike = first_equal_vertex(bare);
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
  const std::vector<std::uint32_t> alike = first_equal_vertex(bare);
  // Rounding must not turn the given angle itself into a crease.
  constexpr double Rounding = 1e-6;
  const grf::Geometry& geometry = *bare.geometry;
  CreasedNormals normals = creased_normals(geometry, grf::first_at_position(geometry), crease + Rounding);
  grf::MeshDraft result = without_geometry(bare);
  std::unordered_map<std::uint64_t, std::uint32_t> vertices;  // by representative vertex and set of corners
  std::vector<std::uint32_t> corners;
  for (std::uint32_t face = 0; face < bare.face_count(); ++face) {
    corners.clear();
    for (std::uint32_t corner = geometry.face_offsets[face]; corner < geometry.face_offsets[face + 1];
         ++corner) {
      const std::uint32_t vertex = alike[geometry.corners[corner]];
      const std::uint32_t set = normals.corners.set_of(corner);
      const auto next = static_cast<std::uint32_t>(result.positions.size());
      const auto [known, is_new] = vertices.emplace(std::uint64_t(vertex) << 32U | set, next);
      corners.push_back(known->second);
      if (!is_new) continue;
      result.copy_vertex(bare, vertex);
      if (const auto normal = normals.at(set)) result.normals.set(next, *normal);
    }
    result.add_face(corners, (*bare.surface_of_face)[face]);
  }
  result.free_spare_memory();
  return result;
}

}  // namespace convert
