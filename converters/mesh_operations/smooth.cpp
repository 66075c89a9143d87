#include "converters/mesh_operations/smooth.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "converters/mesh_operations/edge_rules.h"
#include "converters/mesh_operations/rebuild.h"
#include "converters/mesh_operations/vertex_normals.h"

namespace convert {
namespace {

/// A Laplacian step: moves smooth vertices by a factor towards the mean of their neighbours.
void move_towards_neighbours(const grf::Geometry& geometry, const EdgeRules& rules, double factor,
                             std::vector<grf::Vec3d>& positions) {
  std::vector<grf::Vec3d> sums(positions.size(), grf::Vec3d(0));
  std::vector<std::uint32_t> counts(positions.size());
  for (std::uint32_t edge = 0; edge < rules.edges().edge_count(); ++edge) {
    const grf::HalfEdge& first = rules.edges().faces_at(edge).front();
    const std::uint32_t a = rules.id(geometry.corners[first.corner]);
    const std::uint32_t b = rules.id(geometry.corners[grf::end_corner(geometry, first)]);
    sums[a] += positions[b];
    sums[b] += positions[a];
    ++counts[a];
    ++counts[b];
  }
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    if (counts[i] == 0 || rules.rule(i) != EdgeRules::Rule::Smooth) continue;
    positions[i] += factor * (sums[i] / static_cast<double>(counts[i]) - positions[i]);
  }
}

/// Recomputes the normals of vertices that have one; vertices at one position that shared one still do.
void renew_normals(const grf::Geometry& before, grf::MeshDraft& mesh) {
  if (before.normals.empty()) return;
  const std::vector<std::uint32_t> first = first_with_value(before, &grf::Geometry::normals);
  std::vector<grf::Vec3d> sums(first.size(), grf::Vec3d(0));
  std::vector<grf::Vec3d> of_face;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const auto corners = mesh.face(face);
    weighted_normals(corners, mesh.positions, of_face);
    for (std::size_t k = 0; k < corners.size(); ++k) sums[first[corners[k]]] += of_face[k];
  }
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    const auto normal = unit_normal(sums[first[i]]);
    if (before.normals.has(i) && normal) mesh.normals.set(i, *normal);
  }
}

}  // namespace

grf::Mesh smoothed(const grf::Mesh& mesh, int steps) {
  constexpr double Forth = 0.5;
  constexpr double PassBand = 0.1;
  constexpr double Back = 1 / (PassBand - 1 / Forth);
  const grf::Geometry& geometry = *mesh.geometry;
  const std::vector<std::uint32_t> places = grf::first_at_position(geometry);
  const EdgeRules rules(geometry, places);
  std::vector<grf::Vec3d> positions(geometry.positions.begin(), geometry.positions.end());
  for (int i = 0; i < steps; ++i) {
    move_towards_neighbours(geometry, rules, Forth, positions);
    move_towards_neighbours(geometry, rules, Back, positions);
  }
  grf::MeshDraft result(mesh);
  for (std::size_t i = 0; i < places.size(); ++i) result.positions[i] = grf::Vec3f(positions[places[i]]);
  renew_normals(geometry, result);
  return result;
}

}  // namespace convert
