#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grf/topology.h"

namespace convert {

/// The edge and vertex rules of subdivision and smoothing: neighbours are averaged in the interior, but
/// boundaries depend only on themselves. Boundary edges (of one face) and non-manifold edges (of more than
/// two) are sharp.
class EdgeRules {
 public:
  enum class Rule : std::uint8_t {
    Smooth,  ///< no sharp edge meets the vertex
    Crease,  ///< two sharp edges meet there
    Corner   ///< another number of sharp edges, or several fans of faces that share no edge there
  };

  /// Makes the rules of the surface itself. Vertices with the same entry in `places` are one.
  EdgeRules(const grf::Geometry& geometry, std::span<const std::uint32_t> places);

  /// Makes the rules of an attribute, such as texture coordinates, which has several values at a seam:
  /// vertices with the same entry in `values` have one value. The two sides of a seam are sharp edges between
  /// corners.
  EdgeRules(const grf::Geometry& geometry, std::span<const std::uint32_t> values, const EdgeRules& surface);

  const grf::SharedEdges& edges() const { return edges_; }
  /// Returns the representative of the vertices that are one with a vertex.
  std::uint32_t id(std::uint32_t vertex) const { return ids_[vertex]; }
  bool is_sharp(std::uint32_t edge) const { return is_sharp_[edge]; }
  /// Returns the rule of a representative vertex.
  Rule rule(std::uint32_t id) const { return rules_[id]; }

 private:
  EdgeRules(const grf::Geometry& geometry, std::span<const std::uint32_t> ids, const EdgeRules* surface);

  void find_sharp_edges(const grf::Geometry& geometry, const EdgeRules* surface);
  void find_split_vertices(const grf::Geometry& geometry);

  std::span<const std::uint32_t> ids_;
  grf::SharedEdges edges_;
  std::vector<bool> is_sharp_;
  std::vector<Rule> rules_;
};

}  // namespace convert
