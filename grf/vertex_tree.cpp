#include "grf/vertex_tree.h"

#include <algorithm>
#include <span>

namespace grf {
namespace {

/// The number of consecutive vertices that share a box.
constexpr std::size_t VerticesOfABox = 16;

std::vector<Box3d> boxes_of(const Geometry& geometry) {
  std::vector<Box3d> boxes;
  for (std::size_t i = 0; i < geometry.positions.size(); ++i) {
    if (i % VerticesOfABox == 0) boxes.emplace_back();
    boxes.back().extendBy(Vec3d(geometry.positions[i]));
  }
  return boxes;
}

/// Whether a transform only translates and scales along the axes, so that a transformed box is a tight bound.
bool keeps_axes(const Matrix44d& transform) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      if (row != column && transform[row][column] != 0) return false;
    }
  }
  return transform[3][3] == 1;
}

}  // namespace

VertexTree::VertexTree(const Geometry& geometry) : geometry_(&geometry), boxes_(boxes_of(geometry)) {}

double VertexTree::highest(const Bvh::ValueOfBox& bound, const ValueOfVertex& value, double least,
                           double enough) const {
  const auto highest_of_run = [&](std::size_t run) {
    const auto rest = std::span(geometry_->positions).subspan(run * VerticesOfABox);
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec3f& vertex : rest.first(std::min(VerticesOfABox, rest.size()))) {
      most = std::max(most, value(Vec3d(vertex)));
    }
    return most;
  };
  return boxes_.highest(bound, highest_of_run, least, enough);
}

Box3d VertexTree::bounds_under(const Matrix44d& transform) const {
  Box3d bounds;
  if (boxes_.bounds().isEmpty()) return bounds;
  if (keeps_axes(transform)) {
    bounds.extendBy(boxes_.bounds().min * transform);
    bounds.extendBy(boxes_.bounds().max * transform);
    return bounds;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto highest_along = [&](double sign) {
      const auto value = [&](const Vec3d& vertex) { return sign * (vertex * transform)[axis]; };
      return highest([&](const Box3d& box) { return highest_at_corners(box, value); }, value);
    };
    bounds.min[axis] = -highest_along(-1);
    bounds.max[axis] = highest_along(1);
  }
  return bounds;
}

}  // namespace grf
