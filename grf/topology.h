// The topology of a mesh tells shared edges, boundaries, non-manifold edges and vertices. Vertices at the
// same position count as one, so seams of normals or of texture coordinates are no holes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "grf/disjoint_sets.h"
#include "grf/geometry.h"

namespace grf {

/// Counts of the defects that keep a mesh from being a closed manifold.
struct Topology {
  std::size_t boundary_edges = 0;  ///< edges of only one face
  /// Closed loops of boundary edges: holes and rims of a surface. Loops that meet only at a non-manifold
  /// vertex are separate.
  std::size_t boundary_loops = 0;
  std::size_t nonmanifold_edges = 0;  ///< edges of more than two faces
  /// Vertices at which several fans of faces meet that share no edge there. The ends of non-manifold edges do
  /// not count again.
  std::size_t nonmanifold_vertices = 0;
};

Topology topology_of(const Geometry& geometry);  ///< Counts the borders and defects of a mesh.

/// Returns, for each vertex, the first one at the same position.
std::vector<std::uint32_t> first_at_position(const Geometry& geometry);

/// A half-edge: an edge of one face, from one of its corners to the next.
struct HalfEdge {
  std::uint64_t places = 0;  ///< key: the two ends, each the first vertex there; the smaller in the high word
  std::uint32_t face = 0;
  std::uint32_t corner = 0;  ///< the start of the edge, an index into `Geometry::corners`
};

/// Returns all half-edges that have a length, between the `places` of vertices (usually those of
/// `first_at_position`; empty: each vertex is a place of its own). They are sorted: those between the same
/// places are consecutive, in the order of their faces.
std::vector<HalfEdge> half_edges_of(const Geometry& geometry, std::span<const std::uint32_t> places);

/// Calls a function for each edge, with the run of half-edges that share it.
void for_each_edge(std::span<const HalfEdge> edges,
                   const std::function<void(std::span<const HalfEdge> of_faces)>& action);

/// The edges of a geometry, each with the faces that share it. Pairs of neighbouring faces are not stored:
/// they would be quadratic if many faces share one edge.
class SharedEdges {
 public:
  /// `places`: see `half_edges_of`.
  SharedEdges(const Geometry& geometry, std::span<const std::uint32_t> places);

  static constexpr std::uint32_t InvalidIndex = ~0U;

  /// Returns the number of different edges.
  std::uint32_t edge_count() const { return static_cast<std::uint32_t>(first_.size()); }
  /// Returns the edge that begins at a corner, or InvalidIndex if it has no length.
  std::uint32_t at_corner(std::uint32_t corner) const { return edge_of_corner_[corner]; }
  std::span<const HalfEdge> faces_at(std::uint32_t edge) const {
    const std::size_t last = edge + 1 < first_.size() ? first_[edge + 1] : edges_.size();
    return std::span(edges_).subspan(first_[edge], last - first_[edge]);
  }

 private:
  std::vector<HalfEdge> edges_;
  std::vector<std::uint32_t> first_;  ///< by edge, its first half-edge in edges_
  std::vector<std::uint32_t> edge_of_corner_;
};

/// Returns the corner at the end of the edge.
std::uint32_t end_corner(const Geometry& geometry, const HalfEdge& edge);

/// Joins the sets of the corners of two faces at either end of their shared edge.
void join_at_edge(DisjointSets& corners, const Geometry& geometry, std::span<const std::uint32_t> places,
                  const HalfEdge& a, const HalfEdge& b);

/// Finds the non-manifold places at which several fans of faces meet that share no edge there: their corners
/// are in more than one set of `fans`, which `join_at_edge` has joined. The result is indexed by place.
std::vector<bool> split_vertices(const Geometry& geometry, std::span<const std::uint32_t> places,
                                 DisjointSets& fans);

}  // namespace grf
