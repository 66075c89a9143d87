#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <half.h>

#include "renderer/reflectance/schemes/disc.h"
#include "renderer/reflectance/schemes/split_mix.h"

namespace reflectance {

/// A rectangle of the cells of a grid over [-1,1]^2; ends are exclusive.
struct CellRange {
  int x0, y0, x1, y1;

  bool is_empty() const { return x0 >= x1 || y0 >= y1; }
  bool is_one() const { return x1 - x0 <= 1 && y1 - y0 <= 1; }
  CellRange quarter(int index) const {
    const int x = (x0 + x1) / 2;
    const int y = (y0 + y1) / 2;
    return {index % 2 == 0 ? x0 : x, index < 2 ? y0 : y, index % 2 == 0 ? x : x1, index < 2 ? y : y1};
  }
};

/// A grid over [-1,1]^2, with the area of each cell inside the unit disc.
class DiscGrid {
 public:
  explicit DiscGrid(int resolution);

  int resolution() const { return resolution_; }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * resolution_ + x; }
  float area(int x, int y) const { return areas_[index(x, y)]; }

  static Box box(const CellRange& cells, int resolution);

  /// Returns the cell of a coordinate, clamped to the grid.
  static int cell_of(double coordinate, int resolution) {
    return std::clamp(static_cast<int>((coordinate + 1) / 2 * resolution), 0, resolution - 1);
  }

 private:
  int resolution_;
  std::vector<float> areas_;
};

/// A piecewise-constant function on the unit disc with a quadtree for rejection sampling (section 5.1 of the
/// thesis). A node is split while rejection in it would need more than `most_tries` tries on average, down
/// to single cells. Values are relative to the largest, in half precision, and are exactly what is sampled.
/// Nodes are split between cells, so that all integrals are exact.
class RejectionTree {
 public:
  struct Node {
    float integral = 0;
    float maximum = 0;
    std::int32_t children = -1;  ///< the first of four, or -1 for a leaf
  };
  struct Leaf {
    const Node* node;
    CellRange cells;
  };
  struct Point {
    double x, y;
    int tries;
  };

  /// The maximal number of tries of rejection in a leaf.
  static constexpr int Bound = 4096;
  /// A depth that no tree reaches.
  static constexpr int AnyDepth = 1000;

  RejectionTree() = default;

  /// Builds the tree from values >= 0 of all cells in row order. Those inside the disc are raised to 1 % of
  /// the mean, since f may be larger between the points of evaluation; if all are 0, to one value. An
  /// infinite `most_tries` gives only a root. Without `keep_table` the values are dropped and only leaves
  /// stay. Nodes at `most_depth` are leaves, whatever tries they need; the root has depth 0.
  RejectionTree(const std::vector<float>& values, const DiscGrid& grid, float most_tries, bool keep_table,
                int most_depth = AnyDepth);

  /// Picks a leaf in proportion to its integral; choice is in [0,1).
  Leaf leaf_of(double choice) const;

  /// Distributes samples over the leaves (SplitN and Choose of section 5.3.1): calls visit(leaf, count).
  template <class Visit>
  void distribute(int count, SplitMix& more, Visit visit) const {
    distribute(0, whole(), count, more, visit);
  }

  /// Samples a point of a leaf in proportion to value(x, y), which is at most the leaf's maximum. The first
  /// try is at `first`. Returns nothing if the bound is reached.
  template <class Value>
  std::optional<Point> draw(const Leaf& leaf, const Vec2f& first, SplitMix& more, Value value) const {
    const Box box = inside_disc(DiscGrid::box(leaf.cells, resolution_));
    double s = first.x;
    double t = first.y;
    for (int tries = 1; tries <= Bound; ++tries, s = more.next(), t = more.next()) {
      const Point point{box.x0 + s * (box.x1 - box.x0), box.y0 + t * (box.y1 - box.y0), tries};
      const bool is_inside = point.x * point.x + point.y * point.y < 1;
      if (is_inside && more.next() * leaf.node->maximum < value(point.x, point.y)) return point;
    }
    return std::nullopt;
  }

  bool has_table() const { return !table_.empty(); }

  /// Returns the value at a point, relative to the largest. Needs the table.
  float at(double x, double y) const {
    return table_[static_cast<std::size_t>(DiscGrid::cell_of(y, resolution_)) * resolution_ +
                  DiscGrid::cell_of(x, resolution_)];
  }

  /// Returns the table's entry for a cell's original value.
  half tabulated(float value) const { return std::max(value / largest_, floor_); }

  /// Returns the cell that contains a point.
  Box cell_box(double x, double y) const {
    const int column = DiscGrid::cell_of(x, resolution_);
    const int row = DiscGrid::cell_of(y, resolution_);
    return DiscGrid::box({column, row, column + 1, row + 1}, resolution_);
  }

  /// Returns the pdf on the disc of a value of 1. It accounts for the samples that the bound discards.
  float pdf_of_one() const { return pdf_of_one_; }

  /// Returns the original value of a 1 in the table.
  float largest() const { return largest_; }

  std::span<const Node> nodes() const { return nodes_; }

  /// Returns the cells of the root.
  CellRange whole() const { return {0, 0, resolution_, resolution_}; }

  /// Visits all leaves, depth first: calls visit(leaf, depth).
  template <class Visit>
  void visit_leaves(Visit visit) const {
    visit_leaves(0, whole(), 0, visit);
  }

  std::size_t bytes() const {
    return sizeof(*this) + nodes_.capacity() * sizeof(Node) + table_.capacity() * sizeof(half);
  }

 private:
  void fill(const std::vector<float>& values, const DiscGrid& grid);
  void split(std::size_t index, const CellRange& cells, const DiscGrid& grid, float most_tries, int levels);
  Node measured(const CellRange& cells, const DiscGrid& grid) const;

  /// Distributes `count` points over the four children.
  void split_count(const Node& node, int count, SplitMix& more, int (&counts)[4]) const;

  template <class Visit>
  void distribute(std::size_t index, const CellRange& cells, int count, SplitMix& more, Visit& visit) const {
    const Node& node = nodes_[index];
    if (node.children < 0) return visit(Leaf{&node, cells}, count);
    int counts[4];
    split_count(node, count, more, counts);
    for (int i = 0; i < 4; ++i) {
      if (counts[i] > 0) distribute(node.children + i, cells.quarter(i), counts[i], more, visit);
    }
  }

  template <class Visit>
  void visit_leaves(std::size_t index, const CellRange& cells, int depth, Visit& visit) const {
    const Node& node = nodes_[index];
    if (node.children < 0) return visit(Leaf{&node, cells}, depth);
    for (int i = 0; i < 4; ++i) visit_leaves(node.children + i, cells.quarter(i), depth + 1, visit);
  }

  int resolution_ = 0;
  float largest_ = 0;  ///< the largest value, which is 1 in the table
  float floor_ = 0;    ///< the smallest entry of the table
  float pdf_of_one_ = 0;
  std::vector<Node> nodes_;
  std::vector<half> table_;
};

}  // namespace reflectance
