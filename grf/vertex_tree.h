#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "grf/box_tree.h"
#include "grf/geometry.h"

namespace grf {

/// A tree over the vertices of a mesh, those that no face uses too: it answers what would else need a look at
/// each vertex for each place of the geometry.
class VertexTree {
 public:
  VertexTree() = default;
  /// It must stay as it is.
  explicit VertexTree(const Geometry& geometry);

  /// Whether a vertex lies in a region: `overlap` tells that of whole boxes, `has` of single vertices.
  bool any_in(const BoxTree::OverlapOfBox& overlap, const std::function<bool(const Vec3d&)>& has) const;

  /// The box around all vertices, in the coordinates of the mesh.
  Box3d bounds() const { return boxes_.bounds(); }
  /// The box around all vertices that were transformed: a smaller one than around a box that was.
  Box3d bounds_under(const Matrix44d& transform) const;

 private:
  std::span<const Vec3f> run(std::size_t index) const;
  /// The highest value that a coordinate of the transformed vertices has, times the sign.
  double highest(const Matrix44d& transform, int axis, double sign) const;

  const Geometry* geometry_ = nullptr;
  BoxTree boxes_;  ///< of runs of vertices
};

}  // namespace grf
