#include "converters/mesh_operations/edge_rules.h"

#include <cstddef>

namespace convert {

EdgeRules::EdgeRules(const grf::Geometry& geometry, std::span<const std::uint32_t> places)
    : EdgeRules(geometry, places, nullptr) {}

EdgeRules::EdgeRules(const grf::Geometry& geometry, std::span<const std::uint32_t> values,
                     const EdgeRules& surface)
    : EdgeRules(geometry, values, &surface) {}

EdgeRules::EdgeRules(const grf::Geometry& geometry, std::span<const std::uint32_t> ids,
                     const EdgeRules* surface)
    : ids_(ids),
      edges_(geometry, ids),
      is_sharp_(edges_.edge_count()),
      rules_(geometry.positions.size(), Rule::Smooth) {
  find_sharp_edges(geometry, surface);
  find_split_vertices(geometry);
  for (std::uint32_t i = 0; surface != nullptr && i < rules_.size(); ++i) {
    if (surface->rule(surface->id(i)) == Rule::Corner) rules_[id(i)] = Rule::Corner;
  }
}

void EdgeRules::find_sharp_edges(const grf::Geometry& geometry, const EdgeRules* surface) {
  std::vector<std::uint32_t> sharp_edges(rules_.size());
  std::vector<bool> is_at_seam(rules_.size());
  for (std::uint32_t edge = 0; edge < edges_.edge_count(); ++edge) {
    const auto faces = edges_.faces_at(edge);
    bool is_seam = false;
    is_sharp_[edge] = faces.size() != 2;
    if (surface != nullptr) {
      const std::uint32_t of_surface = surface->edges().at_corner(faces.front().corner);
      const bool has_length = of_surface != grf::SharedEdges::InvalidIndex;
      is_seam = !has_length || surface->edges().faces_at(of_surface).size() != faces.size();
      is_sharp_[edge] = is_sharp_[edge] || is_seam;
    }
    if (!is_sharp_[edge]) continue;
    for (const std::uint32_t corner : {faces.front().corner, grf::end_corner(geometry, faces.front())}) {
      const std::uint32_t vertex = id(geometry.corners[corner]);
      ++sharp_edges[vertex];
      is_at_seam[vertex] = is_at_seam[vertex] || is_seam;
    }
  }
  for (std::size_t i = 0; i < rules_.size(); ++i) {
    if (sharp_edges[i] > 0) rules_[i] = sharp_edges[i] == 2 && !is_at_seam[i] ? Rule::Crease : Rule::Corner;
  }
}

void EdgeRules::find_split_vertices(const grf::Geometry& geometry) {
  grf::DisjointSets fans(geometry.corners.size());
  for (std::uint32_t edge = 0; edge < edges_.edge_count(); ++edge) {
    const auto faces = edges_.faces_at(edge);
    for (const grf::HalfEdge& other : faces.subspan(1)) {
      grf::join_at_edge(fans, geometry, ids_, faces.front(), other);
    }
  }
  const std::vector<bool> are_split = grf::split_vertices(geometry, ids_, fans);
  for (std::size_t i = 0; i < are_split.size(); ++i) {
    if (are_split[i]) rules_[i] = Rule::Corner;
  }
}

}  // namespace convert
