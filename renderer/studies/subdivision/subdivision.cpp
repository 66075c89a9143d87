#include "renderer/studies/subdivision/subdivision.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "renderer/parallel/loops.h"

namespace studies {
namespace {

using plot::Point;
using reflectance::Box;
using reflectance::CellRange;
using reflectance::DiscGrid;
using reflectance::RejectionTree;
using reflectance::Vec2f;
using reflectance::Vec3f;
using Function = std::function<double(const Vec3f&)>;

Vec2f azimuth_of(const Angles& view) {
  return {static_cast<float>(std::cos(view.phi)), static_cast<float>(std::sin(view.phi))};
}

/// Integrates p over the directions above a box inside the disc. In the coordinate that is larger there, the
/// substitution x = w sin t takes the factor 1 / cos(theta) away, which is infinite at the rim.
double integral_over(const Box& box, const Function& pdf) {
  constexpr int Steps = 2;
  const bool is_along_x = std::abs(box.x0 + box.x1) > std::abs(box.y0 + box.y1);
  const auto [low, high] = is_along_x ? std::pair(box.x0, box.x1) : std::pair(box.y0, box.y1);
  const auto [from, to] = is_along_x ? std::pair(box.y0, box.y1) : std::pair(box.x0, box.x1);
  double sum = 0;
  for (int i = 0; i < Steps; ++i) {
    const double across = from + (to - from) * (i + 0.5) / Steps;
    const double width = std::sqrt(std::max(0.0, 1 - across * across));
    if (!(width > 0)) continue;
    const double begin = std::asin(std::clamp(low / width, -1.0, 1.0));
    const double end = std::asin(std::clamp(high / width, -1.0, 1.0));
    for (int k = 0; k < Steps && end > begin; ++k) {
      const double angle = begin + (end - begin) * (k + 0.5) / Steps;
      const double along = width * std::sin(angle);
      const Imath::V3d v(is_along_x ? along : across, is_along_x ? across : along, width * std::cos(angle));
      sum += pdf(Vec3f(v)) * (end - begin) * (to - from) / (Steps * Steps);
    }
  }
  return sum;
}

}  // namespace

Subdivision::Subdivision(const reflectance::Brdf& brdf, const Angles& view, const SubdivisionLimits& limits)
    : grid_(limits.resolution), rotation_(azimuth_of(view).x, azimuth_of(view).y) {
  const Vec3f tree_u = direction_of({view.theta, 0});
  const std::vector<float> values = disc_values(brdf, tree_u, azimuth_of(view), grid_);
  tree_ = RejectionTree(values, grid_, static_cast<float>(limits.most_tries), false, limits.most_depth);
  cell_of_node_.resize(tree_.nodes().size());
  const double whole = tree_.nodes().front().integral;
  tree_.visit_leaves([&](const RejectionTree::Leaf& leaf, int depth) {
    if (!(leaf.node->integral > 0)) return;
    const double area = inside_disc(DiscGrid::box(leaf.cells, grid_.resolution())).area();
    cell_of_node_[static_cast<std::size_t>(leaf.node - tree_.nodes().data())] = cells_.size();
    cells_.push_back({leaf.cells, depth, leaf.node->integral / whole,
                      double(leaf.node->maximum) * tree_.largest(),
                      leaf.node->integral / (leaf.node->maximum * area)});
  });
}

int Subdivision::deepest() const { return std::ranges::max_element(cells_, {}, &Cell::depth)->depth; }

double Subdivision::mean_tries() const {
  double sum = 0;
  for (const Cell& cell : cells_) sum += cell.mass / cell.acceptance;
  return sum;
}

Point Subdivision::to_tree(double x, double y) const {
  const Vec3f local = rotation_.to_plane(Vec3f(Imath::V3d(x, y, 0)));
  return {local.x, local.y};
}

template <class Visit>
void Subdivision::descend(const Point& point, Visit visit) const {
  const int column = DiscGrid::cell_of(point.x, grid_.resolution());
  const int row = DiscGrid::cell_of(point.y, grid_.resolution());
  const RejectionTree::Node* parent = nullptr;
  const RejectionTree::Node* node = tree_.nodes().data();
  CellRange range = tree_.whole();
  visit(*node, range, parent);
  while (node->children >= 0) {
    const CellRange first = range.quarter(0);
    const int quarter = (column < first.x1 ? 0 : 1) + (row < first.y1 ? 0 : 2);
    parent = node;
    node = &tree_.nodes()[static_cast<std::size_t>(node->children) + static_cast<std::size_t>(quarter)];
    range = range.quarter(quarter);
    visit(*node, range, parent);
  }
}

std::optional<std::size_t> Subdivision::cell_at(double x, double y) const {
  if (!(x * x + y * y < 1)) return std::nullopt;
  const RejectionTree::Node* leaf = nullptr;
  descend(to_tree(x, y), [&](const RejectionTree::Node& node, const CellRange&, const RejectionTree::Node*) {
    leaf = &node;
  });
  return cell_of_node_[static_cast<std::size_t>(leaf - tree_.nodes().data())];
}

std::vector<Subdivision::Step> Subdivision::path_to(double x, double y) const {
  std::vector<Step> steps;
  descend(to_tree(x, y), [&](const RejectionTree::Node& node, const CellRange& range,
                             const RejectionTree::Node* parent) {
    double siblings = node.integral;
    if (parent != nullptr) {
      const auto first = tree_.nodes().begin() + parent->children;
      siblings = std::accumulate(first, first + 4, 0.0, [](double sum, const RejectionTree::Node& each) {
        return sum + each.integral;
      });
    }
    steps.push_back({range, node.integral / siblings});
  });
  return steps;
}

std::array<Point, 4> Subdivision::corners(const CellRange& range) const {
  const Box box = DiscGrid::box(range, grid_.resolution());
  std::array<Point, 4> corners = {Point(box.x0, box.y0), Point(box.x1, box.y0), Point(box.x1, box.y1),
                                  Point(box.x0, box.y1)};
  for (Point& corner : corners) {
    const Vec3f turned = rotation_.from_plane(Vec3f(Imath::V3d(corner.x, corner.y, 0)));
    corner = {turned.x, turned.y};
  }
  return corners;
}

std::vector<double> Subdivision::integrals(const Function& pdf,
                                           const std::function<bool()>& is_stopped) const {
  const int resolution = grid_.resolution();
  std::vector<double> values(static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution));
  const Function in_tree_frame = [&](const Vec3f& v) { return pdf(rotation_.from_plane(v)); };
  parallel::for_each_index(resolution, [&](int y) {
    if (is_stopped && is_stopped()) return;
    for (int x = 0; x < resolution; ++x) {
      if (!(grid_.area(x, y) > 0)) continue;
      const Box box = DiscGrid::box({x, y, x + 1, y + 1}, resolution);
      values[grid_.index(x, y)] = integral_over(box, in_tree_frame);
    }
  });
  return values;
}

std::vector<double> Subdivision::sums_over_cells(const std::vector<double>& values) const {
  std::vector<double> sums;
  for (const Cell& cell : cells_) {
    double sum = 0;
    for (int y = cell.range.y0; y < cell.range.y1; ++y) {
      for (int x = cell.range.x0; x < cell.range.x1; ++x) sum += values[grid_.index(x, y)];
    }
    sums.push_back(sum);
  }
  return sums;
}

std::size_t Subdivision::grid_index(double x, double y) const {
  const Point point = to_tree(x, y);
  return grid_.index(DiscGrid::cell_of(point.x, grid_.resolution()),
                     DiscGrid::cell_of(point.y, grid_.resolution()));
}

}  // namespace studies
