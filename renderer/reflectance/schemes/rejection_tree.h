#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <half.h>

#include "renderer/reflectance/schemes/disc.h"
#include "renderer/reflectance/schemes/more_uniforms.h"

namespace reflectance {

/// A rectangle of the cells of a grid over [-1,1]^2; ends are behind the last.
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

/// A grid over [-1,1]^2, and how much of each cell is inside the unit disc.
class DiscGrid {
 public:
  explicit DiscGrid(int resolution);

  int resolution() const { return resolution_; }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * resolution_ + x; }
  float area(int x, int y) const { return areas_[index(x, y)]; }

  static Box box(const CellRange& cells, int resolution);

  /// The cell of a coordinate; what is outside counts to the outermost.
  static int cell_of(double coordinate, int resolution) {
    return std::clamp(static_cast<int>((coordinate + 1) / 2 * resolution), 0, resolution - 1);
  }

 private:
  int resolution_;
  std::vector<float> areas_;
};

/// A function on the unit disc that is constant in each cell of a grid, with a quadtree that draws points by
/// rejection (section 5.1 of the thesis). A node is split while rejection in it would need more than
/// `most_tries` tries in the mean, down to single cells. Values are relative to the largest, as halves: what
/// is drawn from is what these are. Nodes are split between cells, so that all integrals are exact.
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

  /// Rejection in a leaf gives up after so many tries.
  static constexpr int Bound = 4096;

  RejectionTree() = default;

  /// Of values >= 0 of all cells, row by row. Those inside the disc are raised to 1 % of the mean, so that
  /// what is between the points that they were taken at is found; if all are 0, to one value. A `most_tries`
  /// of infinity gives a root alone. Without `keep_table` the values are forgotten and only leaves stay.
  RejectionTree(const std::vector<float>& values, const DiscGrid& grid, float most_tries, bool keep_table);

  /// A leaf by its integral; choice is in [0,1).
  Leaf leaf_of(double choice) const;

  /// Shares a number of points among leaves (SplitN and Choose of section 5.3.1): calls visit(leaf, count).
  template <class Visit>
  void share(int count, MoreUniforms& more, Visit visit) const {
    share(0, whole(), count, more, visit);
  }

  /// A point of a leaf in proportion to value(x, y), which is at most the leaf's maximum. The first try is at
  /// `first`. Nothing if the bound is met.
  template <class Value>
  std::optional<Point> draw(const Leaf& leaf, const Vec2f& first, MoreUniforms& more, Value value) const {
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

  /// Where there is a table: the value at a point, relative to the largest.
  float at(double x, double y) const {
    return table_[static_cast<std::size_t>(DiscGrid::cell_of(y, resolution_)) * resolution_ +
                  DiscGrid::cell_of(x, resolution_)];
  }

  /// What the table has for a value of its cell that it was made from.
  half tabulated(float value) const { return std::max(value / largest_, floor_); }

  /// Of the cell that a point is in.
  Box cell_box(double x, double y) const {
    const int column = DiscGrid::cell_of(x, resolution_);
    const int row = DiscGrid::cell_of(y, resolution_);
    return DiscGrid::box({column, row, column + 1, row + 1}, resolution_);
  }

  /// By this a value becomes a density on the disc. It accounts for the points that the bound leaves out.
  float density_of_one() const { return density_of_one_; }

  std::span<const Node> nodes() const { return nodes_; }
  std::size_t bytes() const {
    return sizeof(*this) + nodes_.capacity() * sizeof(Node) + table_.capacity() * sizeof(half);
  }

 private:
  CellRange whole() const { return {0, 0, resolution_, resolution_}; }
  void fill(const std::vector<float>& values, const DiscGrid& grid);
  void split(std::size_t index, const CellRange& cells, const DiscGrid& grid, float most_tries);
  Node measured(const CellRange& cells, const DiscGrid& grid) const;

  /// How many of `count` points each child gets.
  void split_count(const Node& node, int count, MoreUniforms& more, int (&counts)[4]) const;

  template <class Visit>
  void share(std::size_t index, const CellRange& cells, int count, MoreUniforms& more, Visit& visit) const {
    const Node& node = nodes_[index];
    if (node.children < 0) return visit(Leaf{&node, cells}, count);
    int counts[4];
    split_count(node, count, more, counts);
    for (int i = 0; i < 4; ++i) {
      if (counts[i] > 0) share(node.children + i, cells.quarter(i), counts[i], more, visit);
    }
  }

  int resolution_ = 0;
  float largest_ = 0;  ///< value, which is 1 in the table
  float floor_ = 0;    ///< the least in the table
  float density_of_one_ = 0;
  std::vector<Node> nodes_;
  std::vector<half> table_;
};

}  // namespace reflectance
