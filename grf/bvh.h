#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "grf/math.h"

namespace grf {

/// A bounding volume hierarchy (BVH) over axis-aligned boxes, for branch-and-bound searches that visit only
/// part of the primitives. Building takes O(n log n).
class Bvh {
 public:
  Bvh() = default;
  /// Builds the hierarchy over the bounds of the primitives, by their index. No box may be empty.
  explicit Bvh(std::span<const Box3d> boxes);

  using ValueOfBox = std::function<double(const Box3d&)>;
  using ValueOfPrimitive = std::function<double(std::size_t)>;

  /// Returns the highest value of any primitive, or `least` if none is higher. `bound` returns an upper bound
  /// of the values in a box. The search ends at any value over `enough`.
  double highest(const ValueOfBox& bound, const ValueOfPrimitive& value,
                 double least = -std::numeric_limits<double>::infinity(),
                 double enough = std::numeric_limits<double>::infinity()) const;

  /// Returns the bounds of all primitives; an empty box if there are none.
  Box3d bounds() const { return nodes_.empty() ? Box3d() : nodes_.front().bounds; }

 private:
  struct Node {
    Box3d bounds;
    std::uint32_t first = 0;  ///< the first of its primitives in order_
    std::uint32_t last = 0;   ///< one past its last primitive
    std::uint32_t right = 0;  ///< the second child; the first child follows its parent. 0 for a leaf.
  };

  void build(std::span<const Box3d> boxes, std::uint32_t first, std::uint32_t last);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

/// Returns the highest value at the corners of a box: the maximum of a linear function over the box.
double highest_at_corners(const Box3d& box, const std::function<double(const Vec3d&)>& value);

}  // namespace grf
