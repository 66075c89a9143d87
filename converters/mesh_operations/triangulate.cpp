#include "converters/mesh_operations/triangulate.h"

#include <array>
#include <vector>

#include "converters/mesh_operations/rebuild.h"
#include "grf/triangulation.h"

namespace convert {

grf::Mesh triangulated(const grf::Mesh& mesh) {
  Rebuild rebuild(mesh);
  std::vector<grf::Vec3f> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const auto corners = mesh.face(face);
    positions.clear();
    triangles.clear();
    for (const std::uint32_t corner : corners) positions.push_back(mesh.positions[corner]);
    grf::triangulate(positions, triangles);
    for (const auto& [a, b, c] : triangles) {
      rebuild.add_face(std::array{corners[a], corners[b], corners[c]}, mesh.surface_of_face[face]);
    }
  }
  return rebuild.take();
}

}  // namespace convert
