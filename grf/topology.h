// How the faces of a mesh hang together. Vertices at one place count as one: seams of normals or of texture
// coordinates are no holes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

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

/// All edges that have a length, sorted: those between the same places follow each other, in the order of
/// their faces.
std::vector<FaceEdge> edges_of_faces(const Geometry& geometry, std::span<const std::uint32_t> places);

/// Does something with each run of edges between the same places.
void for_each_edge(std::span<const FaceEdge> edges,
                   const std::function<void(std::span<const FaceEdge> of_faces)>& action);

/// The corner in which the edge ends.
std::uint32_t end_corner(const Geometry& geometry, const FaceEdge& edge);

/// Sets of corners: each is alone at first.
class CornerSets {
 public:
  explicit CornerSets(std::size_t corners);
  void join(std::uint32_t a, std::uint32_t b);
  /// Joins the corners of two faces at either end of an edge that they share.
  void join_at_edge(const Geometry& geometry, std::span<const std::uint32_t> places, const FaceEdge& a,
                    const FaceEdge& b);
  /// One corner of each set stands for it.
  std::uint32_t set_of(std::uint32_t corner);

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace grf
