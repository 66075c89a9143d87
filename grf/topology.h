// How the faces of a mesh hang together. Vertices at one place count as one: seams of normals or of texture
// coordinates are no holes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "grf/disjoint_sets.h"
#include "grf/geometry.h"

namespace grf {

/// What keeps a mesh from being a closed surface.
struct Topology {
  std::size_t boundary_edges = 0;  ///< edges of one face
  /// Closed runs of boundary edges: the holes of a surface and its rims. Runs that meet at a non-manifold
  /// vertex alone are apart.
  std::size_t boundary_loops = 0;
  std::size_t nonmanifold_edges = 0;  ///< edges of more than two faces
  /// Vertices at which parts of a surface meet that share no edge there. The ends of non-manifold edges do
  /// not count once more.
  std::size_t nonmanifold_vertices = 0;
};

Topology topology_of(const Geometry& geometry);

/// For each vertex, the first one at the same place.
std::vector<std::uint32_t> first_at_place(const Geometry& geometry);

/// A face's edge, which leads from one of its corners to the next.
struct FaceEdge {
  std::uint64_t places = 0;  ///< the vertices of both ends, each the first at its place; the lesser one above
  std::uint32_t face = 0;
  std::uint32_t corner = 0;  ///< where it begins, an index of `Geometry::corners`
};

/// All edges that have a length, between the `places` of vertices (those of `first_at_place`, say; empty:
/// each vertex is a place of its own). They are sorted: those between the same places follow each other, in
/// the order of their faces.
std::vector<FaceEdge> edges_of_faces(const Geometry& geometry, std::span<const std::uint32_t> places);

/// Does something with each run of edges between the same places.
void for_each_edge(std::span<const FaceEdge> edges,
                   const std::function<void(std::span<const FaceEdge> of_faces)>& action);

/// The edges of a geometry with the faces that share each. An edge knows its faces, and no face its
/// neighbours: pairs would be quadratic where many faces share one edge.
class SharedEdges {
 public:
  /// `places`: see `edges_of_faces`.
  SharedEdges(const Geometry& geometry, std::span<const std::uint32_t> places);

  static constexpr std::uint32_t None = ~0U;

  std::uint32_t edge_count() const { return static_cast<std::uint32_t>(first_.size()); }
  /// The edge that begins in a corner, or None if it has no length.
  std::uint32_t at_corner(std::uint32_t corner) const { return edge_of_corner_[corner]; }
  std::span<const FaceEdge> faces_at(std::uint32_t edge) const {
    const std::size_t last = edge + 1 < first_.size() ? first_[edge + 1] : edges_.size();
    return std::span(edges_).subspan(first_[edge], last - first_[edge]);
  }

 private:
  std::vector<FaceEdge> edges_;
  std::vector<std::uint32_t> first_;  ///< by edge, the first of its faces in edges_
  std::vector<std::uint32_t> edge_of_corner_;
};

/// The corner in which the edge ends.
std::uint32_t end_corner(const Geometry& geometry, const FaceEdge& edge);

/// Joins the corners of two faces at either end of an edge that they share, in sets of corners.
void join_at_edge(DisjointSets& corners, const Geometry& geometry, std::span<const std::uint32_t> places,
                  const FaceEdge& a, const FaceEdge& b);

/// Finds the places at which parts of a surface meet that share no edge there: corners of more than one set
/// of `fans`, which `join_at_edge` has joined, lie there. The result is indexed by places.
std::vector<bool> split_vertices(const Geometry& geometry, std::span<const std::uint32_t> places,
                                 DisjointSets& fans);

}  // namespace grf
