#pragma once

#include <cstddef>
#include <functional>
#include <limits>

#include "grf/bvh.h"
#include "grf/geometry.h"

namespace grf {

/// A bounding volume hierarchy over the vertices of a mesh, including unused ones: it answers queries without
/// visiting each vertex per instance of the geometry.
class VertexTree {
 public:
  VertexTree() = default;
  /// Builds the tree of a geometry, which must outlive this unchanged.
  explicit VertexTree(const Geometry& geometry);

  using ValueOfVertex = std::function<double(const Vec3d&)>;
  /// Returns the highest value of any vertex, as `Bvh::highest` does.
  double highest(const Bvh::ValueOfBox& bound, const ValueOfVertex& value,
                 double least = -std::numeric_limits<double>::infinity(),
                 double enough = std::numeric_limits<double>::infinity()) const;

  /// Returns the bounds of all vertices, in object space.
  Box3d bounds() const { return boxes_.bounds(); }
  /// Returns the bounds of the transformed vertices: tighter than the transformed bounds.
  Box3d bounds_under(const Matrix44d& transform) const;

 private:
  const Geometry* geometry_ = nullptr;
  Bvh boxes_;  ///< over the bounds of runs of vertices
};

}  // namespace grf
