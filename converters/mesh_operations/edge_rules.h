#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grf/topology.h"

namespace convert {

/// The edge rules say what subdivision and smoothing may do at the vertices and edges of a surface: average
/// neighbours inside, but leave its boundaries to themselves. Edges of one face are boundaries, and edges of
/// more than two faces, which are no part of a manifold, are treated like them: both are sharp.
class EdgeRules {
 public:
  enum class Rule : std::uint8_t {
    Smooth,  ///< no sharp edge meets the vertex
    Crease,  ///< two do
    Corner   ///< any other number, or parts of the surface that share no edge there
  };

  /// These rules are those of the surface itself. Vertices whose entry in `places` is the same are one.
  EdgeRules(const grf::Geometry& geometry, std::span<const std::uint32_t> places);

  /// These rules are those of a value, such as texture coordinates, of which a place may have several, one on
  /// each side of a seam: vertices whose entry in `values` is the same have one value. The two sides of a
  /// seam are sharp edges between corners.
  EdgeRules(const grf::Geometry& geometry, std::span<const std::uint32_t> values, const EdgeRules& surface);

  const grf::SharedEdges& edges() const { return edges_; }
  /// The vertex that stands for those which are one with a vertex.
  std::uint32_t id(std::uint32_t vertex) const { return ids_[vertex]; }
  bool is_sharp(std::uint32_t edge) const { return is_sharp_[edge]; }
  /// The rule for a vertex that stands for others.
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
