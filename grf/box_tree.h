#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
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

  /// A region has none, some or all of what is in a box.
  enum class Overlap { None, Some, All };
  using OverlapOfBox = std::function<Overlap(const Box3d&)>;
  using HasThing = std::function<bool(std::size_t)>;

  /// Whether anything lies in the region: `overlap` tells that of whole boxes, `has_thing` of single things.
  bool any_in(const OverlapOfBox& overlap, const HasThing& has_thing) const;

  using ValueOfBox = std::function<double(const Box3d&)>;
  using ValueOfThing = std::function<double(std::size_t)>;

  /// The highest value of any thing, minus infinity without things. `bound` gives a value for a box that
  /// nothing in it exceeds.
  double highest(const ValueOfBox& bound, const ValueOfThing& value) const;

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

/// The corners of a box, transformed.
std::array<Vec3d, 8> corners_of(const Box3d& box, const Matrix44d& transform);

}  // namespace grf
