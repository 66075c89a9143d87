#include "grf/polygon_sweep.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <boost/intrusive/set.hpp>

namespace grf {
namespace {

using Point = Imath::V2d;

constexpr std::uint32_t NoNode = std::numeric_limits<std::uint32_t>::max();

/// Orders points from left to right, and those with equal x from below: as if the plane were slightly
/// rotated.
bool is_before(const Point& a, const Point& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// A node of a chain, one per corner. A corner that two chains share has a node in each.
struct ChainNode {
  std::uint32_t corner = 0;
  std::uint32_t below = NoNode;
  std::uint32_t above = NoNode;
};

/// The border of the region not triangulated yet, between an edge and the next one above. Seen from the right
/// it is reflex at all corners but the ends, which are the left ends of the two edges.
struct Chain {
  std::uint32_t lowest = NoNode;
  std::uint32_t highest = NoNode;
  std::uint32_t last = NoNode;  ///< the last corner that the sweep met, the rightmost one
};

using TreeHook = boost::intrusive::set_base_hook<boost::intrusive::link_mode<boost::intrusive::normal_link>>;

/// An edge of the polygon; while the sweep line cuts it, it is in the tree.
struct SweptEdge : TreeHook {
  std::uint32_t left = 0;
  std::uint32_t right = 0;
  Point left_end;  ///< copied here for memory locality of searches in the tree
  Point right_end;
  bool is_floor = false;  ///< the interior is above it
  Chain chain;            ///< between a floor and the edge above it
};

/// The tree of edges cut by the sweep line. Edges are inserted at a known position: no two are ever compared.
struct NeverCompared {
  bool operator()(const SweptEdge& /*a*/, const SweptEdge& /*b*/) const { return false; }
};

using EdgeTree = boost::intrusive::set<SweptEdge, boost::intrusive::compare<NeverCompared>,
                                       boost::intrusive::constant_time_size<false>>;

class PolygonSweep {
 public:
  PolygonSweep(std::span<const Point> points, std::vector<std::array<std::uint32_t, 3>>& triangles)
      : points_(points), triangles_(triangles) {}

  bool run();

 private:
  std::uint32_t count() const { return static_cast<std::uint32_t>(corners_.size()); }
  std::uint32_t after(std::uint32_t corner) const { return corner + 1 == count() ? 0 : corner + 1; }
  std::uint32_t ahead_of(std::uint32_t corner) const { return (corner == 0 ? count() : corner) - 1; }
  const Point& at(std::uint32_t corner) const { return points_[corners_[corner]]; }
  bool is_left(std::uint32_t a, std::uint32_t b) const { return is_before(at(a), at(b)); }
  double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return orientation(at(a), at(b), at(c));
  }

  /// Returns a positive value above the edge.
  double side_of(const SweptEdge& edge, std::uint32_t corner) const {
    return orientation(edge.left_end, edge.right_end, at(corner));
  }

  void drop_repeated_corners();
  void make_edges();
  void meet(std::span<const std::uint32_t> corners_at_a_point);

  void sort_starts();
  void nest(std::span<std::uint32_t> corners);
  bool is_outer(std::uint32_t start, std::uint32_t other) const;
  EdgeTree::iterator place_of(std::uint32_t corner);
  bool is_inside(const EdgeTree::const_iterator& place) const {
    return place != tree_.end() && !place->is_floor;
  }
  void start(std::uint32_t corner);
  bool is_under(const SweptEdge& edge, std::uint32_t corner) const;
  bool touches(const EdgeTree::const_iterator& place, std::uint32_t corner) const;
  double distance(const SweptEdge& edge, std::uint32_t corner) const;
  EdgeTree::iterator across_nearest_edge(const EdgeTree::iterator& place, std::uint32_t corner);
  void open(std::uint32_t corner, const EdgeTree::iterator& place);
  void split(std::uint32_t corner, const EdgeTree::iterator& place);
  void pass(std::uint32_t corner);
  void end(std::uint32_t corner);
  bool end_if_adjacent(std::uint32_t corner, EdgeTree::iterator& place);
  void close(const Chain& chain, std::uint32_t corner);
  void merge(Chain& lower, const Chain& upper, std::uint32_t corner);

  std::uint32_t add_node(std::uint32_t corner);
  void join(std::uint32_t below, std::uint32_t above);
  bool is_ear(std::uint32_t a, std::uint32_t tip, std::uint32_t b) const;
  void cut_upwards(std::uint32_t node);
  void cut_downwards(std::uint32_t node);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles_.push_back({corners_[a], corners_[b], corners_[c]});
  }

  std::span<const Point> points_;
  std::vector<std::array<std::uint32_t, 3>>& triangles_;
  std::vector<std::uint32_t> corners_;  ///< without repeated corners
  std::vector<SweptEdge> edges_;        ///< from each corner to the next one
  EdgeTree tree_;                       ///< edges that the sweep line cuts, from below
  std::vector<ChainNode> nodes_;
  std::vector<std::uint32_t> starts_;  ///< corners at one point whose edges both go to the right
  std::vector<bool> is_waiting_;       ///< right ends of two edges with others between them
  bool is_stuck_ = false;
};

bool PolygonSweep::run() {
  const std::size_t before = triangles_.size();
  triangles_.reserve(before + points_.size() - 2);
  drop_repeated_corners();
  if (count() < 3) return false;
  make_edges();
  nodes_.reserve(std::size_t(count()) * 2);
  is_waiting_.resize(count());
  std::vector<std::uint32_t> order(count());
  for (std::uint32_t i = 0; i < count(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return is_left(a, b); });
  for (std::size_t first = 0, last = 0; first < order.size() && !is_stuck_; first = last) {
    while (last < order.size() && at(order[last]) == at(order[first])) ++last;
    meet(std::span(order).subspan(first, last - first));
  }
  return !is_stuck_ && triangles_.size() - before == points_.size() - 2;
}

// Zero-length edges have no left and right end, so they are removed, each with a degenerate triangle.
void PolygonSweep::drop_repeated_corners() {
  const auto size = static_cast<std::uint32_t>(points_.size());
  corners_.reserve(size);
  for (std::uint32_t i = 0; i < size; ++i) {
    if (!corners_.empty() && points_[corners_.back()] == points_[i]) {
      triangles_.push_back({corners_.back(), i, (i + 1) % size});
    } else {
      corners_.push_back(i);
    }
  }
  while (corners_.size() > 2 && points_[corners_.back()] == points_[corners_.front()]) {
    triangles_.push_back({corners_[corners_.size() - 2], corners_.back(), corners_.front()});
    corners_.pop_back();
  }
}

void PolygonSweep::make_edges() {
  edges_.resize(count());
  for (std::uint32_t i = 0; i < count(); ++i) {
    SweptEdge& edge = edges_[i];
    edge.is_floor = is_left(i, after(i));
    edge.left = edge.is_floor ? i : after(i);
    edge.right = edge.is_floor ? after(i) : i;
    edge.left_end = at(edge.left);
    edge.right_end = at(edge.right);
  }
}

// Edges that end at a point are processed before edges that begin there.
void PolygonSweep::meet(std::span<const std::uint32_t> corners_at_a_point) {
  const auto edges_from_left = [&](std::uint32_t corner) {
    return int(is_left(ahead_of(corner), corner)) + int(is_left(after(corner), corner));
  };
  starts_.clear();
  for (const std::uint32_t corner : corners_at_a_point) {
    const int from_left = edges_from_left(corner);
    if (from_left == 2) end(corner);
    if (from_left == 0) starts_.push_back(corner);
  }
  for (const std::uint32_t corner : corners_at_a_point) {
    if (edges_from_left(corner) == 1) pass(corner);
  }
  if (starts_.size() > 1) sort_starts();
  for (std::size_t first = 0, last = 0; first < starts_.size() && !is_stuck_; first = last) {
    while (last < starts_.size() && !is_outer(starts_[first], starts_[last])) ++last;
    const auto alike = std::span(starts_).subspan(first, last - first);
    if (alike.size() > 1) nest(alike);
    for (const std::uint32_t corner : alike) start(corner);
  }
}

// Of two nested wedges that begin at one point, the outer one comes first. A stable sort stays in bounds even
// if rounding makes the order inconsistent.
void PolygonSweep::sort_starts() {
  std::stable_sort(starts_.begin(), starts_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return is_outer(a, b); });
}

bool PolygonSweep::is_outer(std::uint32_t start, std::uint32_t other) const {
  const auto ends_of = [&](std::uint32_t corner) {
    const std::array ends = {after(corner), ahead_of(corner)};
    return turn(corner, ends[0], ends[1]) >= 0 ? ends : std::array{ends[1], ends[0]};
  };
  const auto [low, high] = ends_of(start);
  const auto [other_low, other_high] = ends_of(other);
  const double lower = turn(start, low, other_low);
  if (lower != 0) return lower > 0;
  return turn(start, high, other_high) < 0;
}

/// Orders nested start corners between the same two edges: inside the polygon the outermost one is reflex,
/// and the region that it surrounds is outside.
void PolygonSweep::nest(std::span<std::uint32_t> corners) {
  const bool begins_inside = is_inside(place_of(corners[0]));
  std::array<std::vector<std::uint32_t>, 2> by_kind;
  for (const std::uint32_t corner : corners) {
    const bool is_convex = turn(corner, after(corner), ahead_of(corner)) > 0;
    by_kind[is_convex == begins_inside ? 1 : 0].push_back(corner);
  }
  std::size_t place = 0;
  for (std::size_t i = 0; place < corners.size(); ++i) {
    for (const auto& kind : by_kind) {
      if (i < kind.size()) corners[place++] = kind[i];
    }
  }
}

EdgeTree::iterator PolygonSweep::place_of(std::uint32_t corner) {
  return tree_.lower_bound(corner,
                           [&](const SweptEdge& edge, std::uint32_t met) { return is_under(edge, met); });
}

/// Handles a start corner: both edges go to the right.
void PolygonSweep::start(std::uint32_t corner) {
  auto place = place_of(corner);
  const double angle = turn(corner, after(corner), ahead_of(corner));
  const bool is_convex = angle > 0 || (angle == 0 && !is_inside(place) && !touches(place, corner));
  if (is_convex == is_inside(place)) place = across_nearest_edge(place, corner);
  if (is_stuck_) return;
  if (is_convex) {
    open(corner, place);
  } else {
    split(corner, place);
  }
}

/// Returns whether the edge is below a corner; a corner on the edge is classified by its next points.
bool PolygonSweep::is_under(const SweptEdge& edge, std::uint32_t corner) const {
  const double side = side_of(edge, corner);
  if (side != 0) return side > 0;
  return side_of(edge, after(corner)) + side_of(edge, ahead_of(corner)) > 0;
}

bool PolygonSweep::touches(const EdgeTree::const_iterator& place, std::uint32_t corner) const {
  const auto is_on = [&](const SweptEdge& edge) { return side_of(edge, corner) == 0; };
  return (place != tree_.end() && is_on(*place)) || (place != tree_.begin() && is_on(*std::prev(place)));
}

double PolygonSweep::distance(const SweptEdge& edge, std::uint32_t corner) const {
  return std::abs(side_of(edge, corner)) / (edge.right_end - edge.left_end).length();
}

// Rounding may put a corner that touches an edge on its wrong side.
EdgeTree::iterator PolygonSweep::across_nearest_edge(const EdgeTree::iterator& place, std::uint32_t corner) {
  const bool has_above = place != tree_.end();
  const bool has_below = place != tree_.begin();
  is_stuck_ = !has_above && !has_below;
  if (is_stuck_) return place;
  if (!has_below) return std::next(place);
  const auto below = std::prev(place);
  if (!has_above || distance(*below, corner) <= distance(*place, corner)) return below;
  return std::next(place);
}

void PolygonSweep::open(std::uint32_t corner, const EdgeTree::iterator& place) {
  SweptEdge& floor = edges_[corner];
  const std::uint32_t node = add_node(corner);
  floor.chain = {node, node, node};
  tree_.insert_before(place, floor);
  tree_.insert_before(place, edges_[ahead_of(corner)]);
}

// The new corner sees the rightmost corner of the chain: the chain is split there.
void PolygonSweep::split(std::uint32_t corner, const EdgeTree::iterator& place) {
  Chain& lower = std::prev(place)->chain;
  const std::uint32_t lower_end = lower.last;
  const std::uint32_t upper_end = add_node(nodes_[lower_end].corner);
  const std::uint32_t rest = nodes_[lower_end].above;
  const std::uint32_t top = add_node(corner);
  const std::uint32_t bottom = add_node(corner);
  if (rest != NoNode) join(upper_end, rest);
  join(bottom, upper_end);
  join(lower_end, top);
  SweptEdge& floor = edges_[corner];
  floor.chain = {bottom, rest == NoNode ? upper_end : lower.highest, bottom};
  lower.highest = top;
  lower.last = top;
  cut_downwards(top);
  cut_upwards(bottom);
  tree_.insert_before(place, edges_[ahead_of(corner)]);
  tree_.insert_before(place, floor);
}

/// Handles a regular corner: one edge comes from the left, the other goes to the right.
void PolygonSweep::pass(std::uint32_t corner) {
  const bool is_on_floor = is_left(ahead_of(corner), corner);
  SweptEdge& from = edges_[is_on_floor ? ahead_of(corner) : corner];
  SweptEdge& to = edges_[is_on_floor ? corner : ahead_of(corner)];
  const auto place = tree_.iterator_to(from);
  const std::uint32_t node = add_node(corner);
  Chain& chain = is_on_floor ? from.chain : std::prev(place)->chain;
  if (is_on_floor) {
    join(node, chain.lowest);
    chain.lowest = node;
    cut_upwards(node);
  } else {
    join(chain.highest, node);
    chain.highest = node;
    cut_downwards(node);
  }
  chain.last = node;
  if (is_on_floor) to.chain = chain;
  tree_.replace_node(place, to);
}

/// Handles an end corner: both edges come from the left. If other edges that end at the same point are
/// between them, the corner waits for those.
void PolygonSweep::end(std::uint32_t corner) {
  EdgeTree::iterator place;
  is_waiting_[corner] = true;
  while (is_waiting_[corner] && end_if_adjacent(corner, place)) {
    is_waiting_[corner] = false;
    if (place == tree_.begin() || place == tree_.end()) return;
    if (place->right == std::prev(place)->right) corner = place->right;
  }
}

bool PolygonSweep::end_if_adjacent(std::uint32_t corner, EdgeTree::iterator& place) {
  SweptEdge& floor = edges_[ahead_of(corner)];
  SweptEdge& ceiling = edges_[corner];
  const auto of_floor = tree_.iterator_to(floor);
  const auto of_ceiling = tree_.iterator_to(ceiling);
  if (std::next(of_floor) == of_ceiling) {
    close(floor.chain, corner);
    place = tree_.erase(of_floor, std::next(of_ceiling));
  } else if (std::next(of_ceiling) == of_floor) {
    merge(std::prev(of_ceiling)->chain, floor.chain, corner);
    place = tree_.erase(of_ceiling, std::next(of_floor));
  } else {
    return false;
  }
  return true;
}

void PolygonSweep::close(const Chain& chain, std::uint32_t corner) {
  for (std::uint32_t node = chain.highest; nodes_[node].below != NoNode; node = nodes_[node].below) {
    add_triangle(corner, nodes_[node].corner, nodes_[nodes_[node].below].corner);
  }
}

void PolygonSweep::merge(Chain& lower, const Chain& upper, std::uint32_t corner) {
  const std::uint32_t node = add_node(corner);
  join(lower.highest, node);
  join(node, upper.lowest);
  lower.highest = upper.highest;
  lower.last = node;
  cut_upwards(node);
  cut_downwards(node);
}

std::uint32_t PolygonSweep::add_node(std::uint32_t corner) {
  nodes_.push_back({corner});
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void PolygonSweep::join(std::uint32_t below, std::uint32_t above) {
  nodes_[below].above = above;
  nodes_[above].below = below;
}

/// Returns whether a triangle can be cut off. Overlapping edges that go to the right from the tip have
/// nothing between them; those that come from the left have everything else.
bool PolygonSweep::is_ear(std::uint32_t a, std::uint32_t tip, std::uint32_t b) const {
  const double area = turn(a, tip, b);
  if (area != 0) return area > 0;
  return at(tip) == at(a) || at(tip) == at(b) || (is_left(tip, a) && is_left(tip, b));
}

void PolygonSweep::cut_upwards(std::uint32_t node) {
  const std::uint32_t corner = nodes_[node].corner;
  for (;;) {
    const ChainNode& tip = nodes_[nodes_[node].above];
    if (tip.above == NoNode || !is_ear(nodes_[tip.above].corner, tip.corner, corner)) return;
    add_triangle(nodes_[tip.above].corner, tip.corner, corner);
    join(node, tip.above);
  }
}

void PolygonSweep::cut_downwards(std::uint32_t node) {
  const std::uint32_t corner = nodes_[node].corner;
  for (;;) {
    const ChainNode& tip = nodes_[nodes_[node].below];
    if (tip.below == NoNode || !is_ear(corner, tip.corner, nodes_[tip.below].corner)) return;
    add_triangle(corner, tip.corner, nodes_[tip.below].corner);
    join(tip.below, node);
  }
}

}  // namespace

// Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates, 1997: the
// rounding errors of the products matter only if the difference is nearly zero.
double orientation(const Point& a, const Point& b, const Point& c) {
  const Point ab = b - a;
  const Point ac = c - a;
  const double left = ab.x * ac.y;
  const double right = ab.y * ac.x;
  const double area = left - right;
  constexpr double Rounding = 4e-16;
  if (std::abs(area) > Rounding * (std::abs(left) + std::abs(right))) return area;
  return area + (std::fma(ab.x, ac.y, -left) - std::fma(ab.y, ac.x, -right));
}

bool triangulate_by_sweep(std::span<const Point> points,
                          std::vector<std::array<std::uint32_t, 3>>& triangles) {
  return PolygonSweep(points, triangles).run();
}

}  // namespace grf
