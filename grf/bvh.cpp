#include "grf/bvh.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace grf {
namespace {

constexpr std::uint32_t ThingsOfALeaf = 4;

}  // namespace

Bvh::Bvh(std::span<const Box3d> boxes) : order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (!boxes.empty()) build(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
}

// Each level splits the primitives at the median, so that the depth is the logarithm of their number.
void Bvh::build(std::span<const Box3d> boxes, std::uint32_t first, std::uint32_t last) {
  const std::size_t index = nodes_.size();
  Node node;
  node.first = first;
  node.last = last;
  for (std::uint32_t i = first; i < last; ++i) node.bounds.extendBy(boxes[order_[i]]);
  nodes_.push_back(node);
  if (last - first <= ThingsOfALeaf) return;
  const auto axis = static_cast<int>(node.bounds.majorAxis());
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(
      order_.begin() + first, order_.begin() + middle, order_.begin() + last,
      [&](std::uint32_t a, std::uint32_t b) { return boxes[a].center()[axis] < boxes[b].center()[axis]; });
  build(boxes, first, middle);
  nodes_[index].right = static_cast<std::uint32_t>(nodes_.size());
  build(boxes, middle, last);
}

// The child with the higher bound is visited first, so that the other one can mostly be culled.
double Bvh::highest(const ValueOfBox& bound, const ValueOfPrimitive& value, double least,
                    double enough) const {
  double best = least;
  std::vector<std::pair<double, std::uint32_t>> open;
  const auto add = [&](std::uint32_t index) { open.emplace_back(bound(nodes_[index].bounds), index); };
  if (!nodes_.empty()) add(0);
  while (!open.empty() && best <= enough) {
    const auto [most, index] = open.back();
    const Node& node = nodes_[index];
    open.pop_back();
    if (most <= best) continue;
    if (node.right != 0) {
      add(node.right);
      add(index + 1);
      if (open[open.size() - 2].first > open.back().first) std::swap(open[open.size() - 2], open.back());
      continue;
    }
    for (std::uint32_t i = node.first; i < node.last; ++i) best = std::max(best, value(order_[i]));
  }
  return best;
}

double highest_at_corners(const Box3d& box, const std::function<double(const Vec3d&)>& value) {
  double most = -std::numeric_limits<double>::infinity();
  for (const double x : {box.min.x, box.max.x}) {
    for (const double y : {box.min.y, box.max.y}) {
      for (const double z : {box.min.z, box.max.z}) most = std::max(most, value({x, y, z}));
    }
  }
  return most;
}

}  // namespace grf
