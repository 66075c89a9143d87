#pragma once

#include <cstddef>
#include <functional>
#include <limits>

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

  using ValueOfVertex = std::function<double(const Vec3d&)>;
  /// The highest value of any vertex, found as `BoxTree` finds that of things.
  double highest(const BoxTree::ValueOfBox& bound, const ValueOfVertex& value,
                 double least = -std::numeric_limits<double>::infinity(),
                 double enough = std::numeric_limits<double>::infinity()) const;

  /// The box around all vertices, in the coordinates of the mesh.
  Box3d bounds() const { return boxes_.bounds(); }
  /// The box around all vertices that were transformed: a smaller one than around a box that was.
  Box3d bounds_under(const Matrix44d& transform) const;

 private:
  const Geometry* geometry_ = nullptr;
  BoxTree boxes_;  ///< of runs of vertices
};

}  // namespace grf
