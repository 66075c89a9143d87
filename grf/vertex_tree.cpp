#include "grf/vertex_tree.h"

#include <algorithm>
#include <limits>

namespace grf {
namespace {

/// So many that follow each other share a box.
constexpr std::size_t VerticesOfABox = 16;

std::vector<Box3d> boxes_of(const Geometry& geometry) {
  std::vector<Box3d> boxes;
  for (std::size_t i = 0; i < geometry.positions.size(); ++i) {
    if (i % VerticesOfABox == 0) boxes.emplace_back();
    boxes.back().extendBy(Vec3d(geometry.positions[i]));
  }
  return boxes;
}

}  // namespace

VertexTree::VertexTree(const Geometry& geometry) : geometry_(&geometry), boxes_(boxes_of(geometry)) {}

std::span<const Vec3f> VertexTree::run(std::size_t index) const {
  const auto rest = std::span(geometry_->positions).subspan(index * VerticesOfABox);
  return rest.first(std::min(VerticesOfABox, rest.size()));
}

bool VertexTree::any_in(const BoxTree::OverlapOfBox& overlap,
                        const std::function<bool(const Vec3d&)>& has) const {
  return boxes_.any_in(overlap, [&](std::size_t index) {
    const auto vertices = run(index);
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](const Vec3f& vertex) { return has(Vec3d(vertex)); });
  });
}

double VertexTree::highest(const Matrix44d& transform, int axis, double sign) const {
  const auto bound = [&](const Box3d& box) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec3d& corner : corners_of(box, transform)) most = std::max(most, sign * corner[axis]);
    return most;
  };
  return boxes_.highest(bound, [&](std::size_t index) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec3f& vertex : run(index)) most = std::max(most, sign * (Vec3d(vertex) * transform)[axis]);
    return most;
  });
}

Box3d VertexTree::bounds_under(const Matrix44d& transform) const {
  Box3d bounds;
  if (boxes_.bounds().isEmpty()) return bounds;
  for (int axis = 0; axis < 3; ++axis) {
    bounds.min[axis] = -highest(transform, axis, -1);
    bounds.max[axis] = highest(transform, axis, 1);
  }
  return bounds;
}

}  // namespace grf
