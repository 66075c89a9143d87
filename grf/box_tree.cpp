#include "grf/box_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace grf {
namespace {

constexpr std::uint32_t ThingsOfALeaf = 4;

}  // namespace

BoxTree::BoxTree(std::span<const Box3d> boxes) : order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (!boxes.empty()) build(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
}

// The things are halved at each level, so that the depth is the logarithm of their number.
void BoxTree::build(std::span<const Box3d> boxes, std::uint32_t first, std::uint32_t last) {
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

bool BoxTree::any_in(const OverlapOfBox& overlap, const HasThing& has_thing) const {
  std::vector<std::uint32_t> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    const Node& node = nodes_[index];
    open.pop_back();
    const Overlap found = overlap(node.bounds);
    if (found == Overlap::None) continue;
    if (found == Overlap::All) return true;
    if (node.right != 0) {
      open.push_back(node.right);
      open.push_back(index + 1);
      continue;
    }
    for (std::uint32_t i = node.first; i < node.last; ++i) {
      if (has_thing(order_[i])) return true;
    }
  }
  return false;
}

// The more promising child is looked at first, so that the other one can mostly be left out.
double BoxTree::highest(const ValueOfBox& bound, const ValueOfThing& value) const {
  double best = -std::numeric_limits<double>::infinity();
  std::vector<std::pair<double, std::uint32_t>> open;
  const auto add = [&](std::uint32_t index) { open.emplace_back(bound(nodes_[index].bounds), index); };
  if (!nodes_.empty()) add(0);
  while (!open.empty()) {
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

std::array<Vec3d, 8> corners_of(const Box3d& box, const Matrix44d& transform) {
  std::array<Vec3d, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d corner((i & 1U) != 0 ? box.max.x : box.min.x, (i & 2U) != 0 ? box.max.y : box.min.y,
                       (i & 4U) != 0 ? box.max.z : box.min.z);
    corners[i] = corner * transform;
  }
  return corners;
}

}  // namespace grf
