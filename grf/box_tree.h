#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "grf/math.h"

namespace grf {

/// A bounding volume hierarchy of axis-aligned boxes: it finds what
/// is asked of many things without a look at each. It is built in n log n.
class BoxTree {
 public:
  BoxTree() = default;
  /// Takes the boxes of the things, by their index. None may be empty.
  explicit BoxTree(std::span<const Box3d> boxes);

  using ValueOfBox = std::function<double(const Box3d&)>;
  using ValueOfThing = std::function<double(std::size_t)>;

  /// The highest value of any thing, or `least` if none is higher. `bound` gives a value for a box that
  /// nothing in it exceeds. The search ends at any value over `enough`.
  double highest(const ValueOfBox& bound, const ValueOfThing& value,
                 double least = -std::numeric_limits<double>::infinity(),
                 double enough = std::numeric_limits<double>::infinity()) const;

  /// The box around all; an empty one without things.
  Box3d bounds() const { return nodes_.empty() ? Box3d() : nodes_.front().bounds; }

 private:
  struct Node {
    Box3d bounds;
    std::uint32_t first = 0;  ///< of its things in order_
    std::uint32_t last = 0;   ///< one past them
    std::uint32_t right = 0;  ///< the second child; the first follows its parent. 0 for a leaf.
  };

  void build(std::span<const Box3d> boxes, std::uint32_t first, std::uint32_t last);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

/// The highest value at the corners of a box, which a linear function exceeds nowhere inside.
double highest_at_corners(const Box3d& box, const std::function<double(const Vec3d&)>& value);

}  // namespace grf
