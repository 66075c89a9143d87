// How a sample walks down the trees of WarpTrees. This is where the time of a sample goes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "renderer/reflectance/schemes/warp_tree.h"

namespace reflectance {

/// A sample on its way down: the pair of uniform numbers, of which each choice uses up a part, and the square
/// of a column that it is in. Choices have no branches, which no processor could predict.
struct WarpDescent {
  Vec2f rest;
  std::size_t column = 0;
  Vec2f corner = Vec2f(0);
  float side = 1;

  void choose_column(const std::array<float, 4>& masses) {
    const float left = masses[0] + masses[1];
    const float x = rest.x * (left + masses[2] + masses[3]);
    const std::size_t half = x >= left ? 2 : 0;
    const float rest_of_x = x - (half != 0 ? left : 0);
    const std::size_t second = rest_of_x >= masses[half] ? 1 : 0;
    column = half + second;
    rest.x = uniform((rest_of_x - (second != 0 ? masses[half] : 0)) / masses[column]);
  }

  /// The child that the numbers choose, left or right first.
  std::size_t choose(const BilinearPatch& means) {
    const float left = means[0] + means[2];
    const float both = left + means[1] + means[3];
    const float x = rest.x * both;
    const std::size_t right = x >= left ? 1 : 0;
    const float chosen = right != 0 ? both - left : left;
    rest.x = uniform((x - (right != 0 ? left : 0)) / chosen);
    const float bottom = means[right];
    const float y = rest.y * chosen;
    const std::size_t top = y >= bottom ? 1 : 0;
    rest.y = uniform((y - (top != 0 ? bottom : 0)) / (top != 0 ? chosen - bottom : bottom));
    side /= 2;
    corner += side * Vec2f(static_cast<float>(right), static_cast<float>(top));
    return right + 2 * top;
  }

 private:
  static float uniform(float x) { return std::clamp(x, 0.0F, 0x1.fffffep-1F); }
};

/// Where a sample is in one tree: at an inner node, or within a leaf, or within a part of a leaf that another
/// tree divides further.
class WarpCursor {
 public:
  WarpCursor() = default;
  WarpCursor(const WarpQuad* quads, float weight, std::size_t column)
      : quads_(quads), quad_(quads), weight_(weight) {
    if (quads != nullptr) enter(column);
  }

  bool is_patch() const { return quad_ == nullptr; }
  const BilinearPatch& patch() const { return patch_; }
  float weight() const { return weight_; }

  void add_child_means(BilinearPatch& sums) const {
    if (!is_patch()) {
      for (std::size_t k = 0; k < 4; ++k) sums[k] += weight_ * (*quad_)[k].mean();
      return;
    }
    // The mean of a bilinear function is its value in the middle.
    const auto& [p, q, r, s] = patch_;
    const float sixteenth = weight_ / 16;
    sums[0] += sixteenth * (9 * p + 3 * q + 3 * r + s);
    sums[1] += sixteenth * (3 * p + 9 * q + r + 3 * s);
    sums[2] += sixteenth * (3 * p + q + 9 * r + 3 * s);
    sums[3] += sixteenth * (p + 3 * q + 3 * r + 9 * s);
  }

  void enter(std::size_t child) {
    if (!is_patch()) {
      const WarpNode& node = (*quad_)[child];
      quad_ = node.is_leaf() ? nullptr : quads_ + node.children();
      if (node.is_leaf()) patch_ = node.patch();
      return;
    }
    const Vec2f low(child % 2 == 0 ? 0.0F : 0.5F, child < 2 ? 0.0F : 0.5F);
    const Vec2f high = low + Vec2f(0.5F);
    patch_ = {value_at(patch_, low), value_at(patch_, {high.x, low.y}), value_at(patch_, {low.x, high.y}),
              value_at(patch_, high)};
  }

 private:
  const WarpQuad* quads_ = nullptr;
  const WarpQuad* quad_ = nullptr;
  float weight_ = 0;
  BilinearPatch patch_ = {};
};

/// Walks down the first `Count` of several trees at once, from the roots of the descent's column to where it
/// is within a leaf of each, and gives the blend of the leaves. Parts without a tree count for nothing.
template <std::size_t Count, class Parts>
BilinearPatch walk_down(const Parts& parts, WarpDescent& descent) {
  std::array<WarpCursor, Count> cursors;
  for (std::size_t i = 0; i < Count; ++i) cursors[i] = {parts[i].quads, parts[i].weight, descent.column};
  const auto is_inside = [](const WarpCursor& cursor) { return cursor.is_patch(); };
  while (!std::all_of(cursors.begin(), cursors.end(), is_inside)) {
    BilinearPatch means = {};
    for (const WarpCursor& cursor : cursors) cursor.add_child_means(means);
    const std::size_t child = descent.choose(means);
    for (WarpCursor& cursor : cursors) cursor.enter(child);
  }
  BilinearPatch patch = {};
  for (const WarpCursor& cursor : cursors) {
    for (std::size_t k = 0; k < 4; ++k) patch[k] += cursor.weight() * cursor.patch()[k];
  }
  return patch;
}

/// The tree's value at a point.
inline float value_at(const WarpQuad* quads, const ColumnPoint& point) {
  Vec2f local = point.local;
  const WarpNode* node = &(*quads)[point.column];
  while (!node->is_leaf()) {
    local *= 2;
    const std::size_t right = local.x >= 1 ? 1 : 0;
    const std::size_t top = local.y >= 1 ? 1 : 0;
    local -= Vec2f(static_cast<float>(right), static_cast<float>(top));
    node = &quads[node->children()][right + 2 * top];
  }
  return value_at(node->patch(), local);
}

}  // namespace reflectance
