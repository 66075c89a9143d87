#include "renderer/reflectance/schemes/warp_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace reflectance {
namespace {

// Positions on a cell in a 3 x 3 grid: corners, edge midpoints and centre.
constexpr std::array<int, 4> NodeCorners = {0, 2, 6, 8};
constexpr std::array<int, 5> Inner = {1, 3, 4, 5, 7};
constexpr std::array<float, 5> InnerShares = {0.15F, 0.15F, 0.4F, 0.15F, 0.15F};

Vec2f place_on_grid(int place) {
  return {static_cast<float>(place % 3) / 2, static_cast<float>(place / 3) / 2};
}

struct Cell {
  std::size_t column = 0;
  std::uint32_t x = 0, y = 0;  ///< of the lower left corner, in units of the side
  int depth = 0;
  int children = -1;  ///< index of the first of four
  std::array<float, 9> values = {};
  float error = 0;
  float largest_ratio = 1;

  float side() const { return std::ldexp(1.0F, -depth); }
  BilinearPatch patch() const { return {values[0], values[2], values[6], values[8]}; }
  bool is_leaf() const { return children < 0; }
  Vec2f to_square(const Vec2f& local) const {
    return {(static_cast<float>(x) + local.x) * side(), (static_cast<float>(y) + local.y) * side()};
  }
  Vec2f to_local(const Vec2f& point) const {
    return {point.x / side() - static_cast<float>(x), point.y / side() - static_cast<float>(y)};
  }
};

class Builder {
 public:
  Builder(const ColumnFunction& function, const std::array<float, 4>& widths, const WarpTreeLimits& limits)
      : function_(function), widths_(widths), limits_(limits) {
    for (std::size_t column = 0; column < widths_.size(); ++column) {
      Cell root;
      root.column = column;
      for (int place = 0; place < 9; ++place) evaluate(root, place);
      measure(root);
      cells_.push_back(root);
    }
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (cells_[i].depth < LeastDepth) split(i);
    }
  }

  void look_at(const ColumnPoint& probe) {
    constexpr float Missed = 1.5F;
    for (;;) {
      const std::size_t leaf = leaf_at(probe);
      Cell& cell = cells_[leaf];
      const float value = function_(probe, cell.side());
      const float ratio = ratio_of(value, value_at(cell.patch(), cell.to_local(probe.local)));
      if (!(ratio > Missed)) return;
      if (!may_split(cell)) {
        cell.largest_ratio = std::max(cell.largest_ratio, ratio);
        return;
      }
      split(leaf);
    }
  }

  void refine() {
    double error = 0;
    double sum = 0;
    std::priority_queue<std::pair<float, std::size_t>> worst;
    const auto add = [&](std::size_t i) {
      error += cells_[i].error;
      sum += mean(cells_[i].patch()) * area(cells_[i]);
      if (may_split(cells_[i])) worst.emplace(cells_[i].error, i);
    };
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (cells_[i].is_leaf()) add(i);
    }
    while (!worst.empty() && error > limits_.error * sum && may_grow()) {
      const std::size_t i = worst.top().second;
      worst.pop();
      error -= cells_[i].error;
      sum -= mean(cells_[i].patch()) * area(cells_[i]);
      split(i);
      for (std::size_t k = 0; k < 4; ++k) add(static_cast<std::size_t>(cells_[i].children) + k);
    }
  }

  WarpTree result() const {
    WarpTree tree;
    float sum = 0;
    float room = 0;
    for (const Cell& cell : cells_) {
      if (!cell.is_leaf()) continue;
      sum += mean(final_patch(cell, 0)) * area(cell);
      room += area(cell);
    }
    if (sum > 0) fill(tree, FloorShare * sum / room);
    return tree;
  }

 private:
  static constexpr float FloorShare = 1.0F / 256;
  static constexpr int LeastDepth = 2;  // of a tree's top

  static float ratio_of(float value, float table) {
    if (!(value > 0)) return 1;
    return table > 0 ? value / table : std::numeric_limits<float>::max();
  }

  float area(const Cell& cell) const { return widths_[cell.column] * cell.side() * cell.side(); }

  bool may_grow() const { return cells_.size() / 4 < static_cast<std::size_t>(limits_.most_quads); }
  bool may_split(const Cell& cell) const { return cell.depth < limits_.most_depth && may_grow(); }

  void evaluate(Cell& cell, int place) const {
    cell.values[static_cast<std::size_t>(place)] =
        function_({cell.column, cell.to_square(place_on_grid(place))}, cell.side());
  }

  /// Measures the leaf's contribution to the variance of f/g, from the five points that are no corners.
  void measure(Cell& cell) const {
    const BilinearPatch patch = cell.patch();
    const float floor = FloorShare * mean(patch);
    float error = 0;
    for (std::size_t i = 0; i < Inner.size(); ++i) {
      const float value = cell.values[static_cast<std::size_t>(Inner[i])];
      const float table = std::max(value_at(patch, place_on_grid(Inner[i])), floor);
      const float difference = value - table;
      if (value > 0 || table > 0)
        error += InnerShares[i] * difference * difference / std::max(table, 0.1F * value);
      cell.largest_ratio = std::max(cell.largest_ratio, ratio_of(value, table));
    }
    // Too small a pdf costs more than too large a one: it makes single samples of large weight.
    constexpr float LargeWeight = 1.2F;
    if (cell.largest_ratio > LargeWeight) error *= 4;
    cell.error = error * area(cell);
  }

  void split(std::size_t i) {
    const int children = static_cast<int>(cells_.size());
    cells_[i].children = children;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const Cell& parent = cells_[i];
      Cell child;
      child.column = parent.column;
      child.x = 2 * parent.x + k % 2;
      child.y = 2 * parent.y + k / 2;
      child.depth = parent.depth + 1;
      for (const int place : NodeCorners) {
        const std::uint32_t column = k % 2 + static_cast<std::uint32_t>(place) % 3 / 2;
        const std::uint32_t row = k / 2 + static_cast<std::uint32_t>(place) / 6;
        child.values[static_cast<std::size_t>(place)] = parent.values[3 * row + column];
        if (is_at_border(child, place)) evaluate(child, place);
      }
      for (const int place : Inner) evaluate(child, place);
      measure(child);
      cells_.push_back(child);
    }
  }

  // Returns true at a border, where the value depends on the cell's size.
  static bool is_at_border(const Cell& cell, int place) {
    const Vec2f point = cell.to_square(place_on_grid(place));
    return point.x <= 0 || point.x >= 1 || point.y <= 0 || point.y >= 1;
  }

  std::size_t leaf_at(const ColumnPoint& point) const {
    std::size_t i = point.column;
    while (!cells_[i].is_leaf()) {
      const Vec2f local = cells_[i].to_local(point.local);
      i = static_cast<std::size_t>(cells_[i].children) + (local.x >= 0.5F ? 1 : 0) +
          (local.y >= 0.5F ? 2 : 0);
    }
    return i;
  }

  // Returns the leaf's patch. A leaf that cannot be split further is raised, so that no weight is large.
  BilinearPatch final_patch(const Cell& cell, float floor) const {
    constexpr float FairRatio = 1.1F;
    constexpr float MostRaise = 16;
    const float raise = std::clamp(cell.largest_ratio / FairRatio, 1.0F, MostRaise);
    BilinearPatch patch = cell.patch();
    const float least = std::max(floor, raise > 1 ? 0.1F * mean(patch) : 0.0F);
    for (float& value : patch) value = std::max(value * raise, least);
    return patch;
  }

  void fill(WarpTree& tree, float floor) const {
    for (std::size_t column = 0; column < 4; ++column) {
      for (std::uint32_t x = 0; x < WarpTop::Side; ++x) {
        for (std::uint32_t y = 0; y < WarpTop::Side; ++y) {
          set_node(tree, tree.top.strips[column][x], y, cell_of_top(column, x, y), floor);
        }
        tree.top.strip_means[column][x] = mean(tree.top.strips[column][x].means());
      }
      tree.top.column_means[column] = mean(tree.top.strip_means[column]);
    }
  }

  const Cell& cell_of_top(std::size_t column, std::uint32_t x, std::uint32_t y) const {
    const Cell& half = cells_[static_cast<std::size_t>(cells_[column].children) + x / 2 + y / 2 * 2];
    return cells_[static_cast<std::size_t>(half.children) + x % 2 + y % 2 * 2];
  }

  void set_node(WarpTree& tree, WarpQuad& quad, std::size_t node, const Cell& cell, float floor) const {
    if (cell.is_leaf()) return quad.set_leaf(node, final_patch(cell, floor));
    const std::size_t children = tree.quads.size();
    tree.quads.emplace_back();
    WarpQuad below;
    for (std::size_t k = 0; k < 4; ++k) {
      set_node(tree, below, k, cells_[static_cast<std::size_t>(cell.children) + k], floor);
    }
    tree.quads[children] = below;
    quad.set_inner(node, mean(below.means()), static_cast<std::uint32_t>(children));
  }

  const ColumnFunction& function_;
  std::array<float, 4> widths_;
  WarpTreeLimits limits_;
  std::vector<Cell> cells_;
};

}  // namespace

void WarpQuad::set_leaf(std::size_t node, const BilinearPatch& patch) {
  const float largest = *std::max_element(patch.begin(), patch.end());
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const float root = std::sqrt(patch[i] / largest);
    word |= static_cast<std::uint32_t>(std::lround(root * LargestRoot)) << (8 * i);
  }
  means_[node] = mean(patch);
  words_[node] = word;
}

void WarpQuad::set_inner(std::size_t node, float mean, std::uint32_t children) {
  means_[node] = mean;
  words_[node] = InnerMark + children;
}

WarpTree WarpTree::build(const ColumnFunction& function, const std::array<float, 4>& widths,
                         std::span<const ColumnPoint> probes, const WarpTreeLimits& limits) {
  Builder builder(function, widths, limits);
  for (const ColumnPoint& probe : probes) builder.look_at(probe);
  builder.refine();
  return builder.result();
}

}  // namespace reflectance
