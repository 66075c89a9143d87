#include "renderer/reflectance/schemes/rejection_tree.h"

namespace reflectance {

DiscGrid::DiscGrid(int resolution)
    : resolution_(resolution), areas_(static_cast<std::size_t>(resolution) * resolution) {
  for (int y = 0; y < resolution; ++y) {
    for (int x = 0; x < resolution; ++x) {
      areas_[index(x, y)] = static_cast<float>(disc_area(box({x, y, x + 1, y + 1}, resolution)));
    }
  }
}

Box DiscGrid::box(const CellRange& cells, int resolution) {
  const auto edge = [&](int cell) { return 2.0 * cell / resolution - 1; };
  return {edge(cells.x0), edge(cells.y0), edge(cells.x1), edge(cells.y1)};
}

RejectionTree::RejectionTree(const std::vector<float>& values, const DiscGrid& grid, float most_tries,
                             bool keep_table, int most_depth)
    : resolution_(grid.resolution()) {
  fill(values, grid);
  nodes_.push_back(measured(whole(), grid));
  split(0, whole(), grid, most_tries, most_depth);
  nodes_.shrink_to_fit();

  const Node& root = nodes_.front();
  // Leaves of a subdivided tree are hit too often for the bound to matter.
  const double hit = root.integral / (root.maximum * Box().area());
  const double reached = root.children < 0 ? -std::expm1(Bound * std::log1p(-hit)) : 1;
  pdf_of_one_ = static_cast<float>(reached / root.integral);
  if (!keep_table) std::vector<half>().swap(table_);
}

void RejectionTree::fill(const std::vector<float>& values, const DiscGrid& grid) {
  constexpr double Floor = 0.01;
  constexpr float LeastHalf = 0x1p-24F;
  double integral = 0;
  for (int y = 0; y < resolution_; ++y) {
    for (int x = 0; x < resolution_; ++x) {
      const float value = values[grid.index(x, y)];
      largest_ = std::max(largest_, value);
      integral += double(value) * grid.area(x, y);
    }
  }
  const bool is_black = !(largest_ > 0);
  if (is_black) largest_ = 1;
  const double least = is_black ? 1 : Floor / std::numbers::pi * integral / largest_;
  floor_ = half(std::max(static_cast<float>(least), LeastHalf));
  table_.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) table_[i] = tabulated(values[i]);
}

RejectionTree::Node RejectionTree::measured(const CellRange& cells, const DiscGrid& grid) const {
  double integral = 0;
  float maximum = 0;
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int x = cells.x0; x < cells.x1; ++x) {
      const float area = grid.area(x, y);
      if (!(area > 0)) continue;
      const float value = table_[grid.index(x, y)];
      integral += double(value) * area;
      maximum = std::max(maximum, value);
    }
  }
  return {static_cast<float>(integral), maximum, -1};
}

/// Splits a node that needs it, and the nodes below it down to so many levels.
void RejectionTree::split(std::size_t index, const CellRange& cells, const DiscGrid& grid, float most_tries,
                          int levels) {
  const Node node = nodes_[index];
  if (levels <= 0 || cells.is_one() || !(node.integral > 0)) return;
  const double volume = inside_disc(DiscGrid::box(cells, resolution_)).area() * node.maximum;
  if (node.integral * most_tries >= volume) return;
  const std::size_t children = nodes_.size();
  nodes_[index].children = static_cast<std::int32_t>(children);
  for (int i = 0; i < 4; ++i) nodes_.push_back(measured(cells.quarter(i), grid));
  for (int i = 0; i < 4; ++i) split(children + i, cells.quarter(i), grid, most_tries, levels - 1);
}

RejectionTree::Leaf RejectionTree::leaf_of(double choice) const {
  Leaf leaf{nodes_.data(), whole()};
  while (leaf.node->children >= 0) {
    const Node* children = &nodes_[leaf.node->children];
    double total = 0;
    for (int i = 0; i < 4; ++i) total += children[i].integral;
    double rest = choice * total;
    int chosen = 0;
    for (int i = 0; i < 4; ++i) {
      if (!(children[i].integral > 0)) continue;
      chosen = i;
      if (rest < children[i].integral) break;
      rest -= children[i].integral;
    }
    choice = std::clamp(rest / children[chosen].integral, 0.0, 1.0);
    leaf = {&children[chosen], leaf.cells.quarter(chosen)};
  }
  return leaf;
}

void RejectionTree::split_count(const Node& node, int count, SplitMix& more, int (&counts)[4]) const {
  const Node* children = &nodes_[node.children];
  double total = 0;
  for (int i = 0; i < 4; ++i) total += children[i].integral;
  double rests[4];
  int left = count;
  for (int i = 0; i < 4; ++i) {
    const double expected = count * (children[i].integral / total);
    counts[i] = std::min(static_cast<int>(expected), left);
    rests[i] = expected - counts[i];
    left -= counts[i];
  }
  const double rest_of_all = rests[0] + rests[1] + rests[2] + rests[3];
  for (; left > 0; --left) {
    double lot = more.next() * rest_of_all;
    int chosen = 0;
    for (int i = 0; i < 4 && lot >= 0; ++i) {
      if (!(rests[i] > 0)) continue;
      chosen = i;
      lot -= rests[i];
    }
    ++counts[chosen];
  }
}

}  // namespace reflectance
