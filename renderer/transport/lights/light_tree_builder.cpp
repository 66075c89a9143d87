#include "renderer/transport/lights/light_tree_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "renderer/parallel/loops.h"
#include "renderer/transport/scene/ray_offset.h"

namespace transport {
namespace {

/// Subtrees with more emitters are built in parallel.
constexpr std::size_t ParallelCount = 4096;

Vec3f doubled_centre(const Box3f& box) { return box.min + box.max; }

double surface_area(const Box3f& box) {
  const Vec3f size = box.max - box.min;
  return 2 * (double(size.x) * size.y + double(size.y) * size.z + double(size.z) * size.x);
}

/// The orientation cost of a cone of normals of diffuse emitters (equation 1 of the paper, whose second angle
/// is pi/2).
double orientation_cost(float cosine) {
  constexpr double Pi = std::numbers::pi;
  const double angle = std::acos(std::clamp(double(cosine), -1.0, 1.0));
  const double reach = std::min(angle + Pi / 2, Pi);
  const double sine = std::sin(angle);
  return 2 * Pi * (1 - cosine) +
         Pi / 2 * (2 * reach * sine - std::cos(angle - 2 * reach) - 2 * angle * sine + cosine);
}

}  // namespace

void LightTreeBuilder::Extent::extend_by(const Extent& other) {
  if (other.count == 0) return;
  normals = count == 0 ? other.normals : merged(normals, other.normals);
  box.extendBy(other.box);
  power += other.power;
  count += other.count;
}

double LightTreeBuilder::Extent::cost() const {
  return power * orientation_cost(normals.cosine) * surface_area(box);
}

LightTreeBuilder::LightTreeBuilder(std::span<const Emitter> emitters, LightTree& tree) : tree_(tree) {
  items_.reserve(emitters.size());
  for (std::size_t i = 0; i < emitters.size(); ++i) {
    items_.push_back(item_of(emitters[i], static_cast<std::uint32_t>(i)));
  }
}

LightTreeBuilder::Item LightTreeBuilder::item_of(const Emitter& emitter, std::uint32_t index) {
  const LightBounds bounds = bounds_of(emitter);
  return {bounds.box, bounds.normals.axis, bounds.power, index};
}

void LightTreeBuilder::build() {
  clusters_.resize(2 * items_.size() - 1);
  build(items_, 0);
  tree_.place_of_emitter_.resize(items_.size());
  join(0, {});
  tree_.nodes_.shrink_to_fit();
}

// A tree of n emitters has 2 n - 1 clusters, so each subtree knows its indices and needs no synchronisation.
LightTreeBuilder::Extent LightTreeBuilder::build(Items items, std::uint32_t cluster) {
  Cluster& here = clusters_[cluster];
  here.count = static_cast<std::uint32_t>(items.size());
  if (items.size() == 1) {
    const Item& item = items[0];
    here.emitter_or_second = item.emitter;
    here.bounds = {item.box, {item.normal, 1}, item.power};
    return {item.box, {item.normal, 1}, item.power, 1};
  }
  const std::size_t middle = partition(items);
  here.emitter_or_second = cluster + 2 * static_cast<std::uint32_t>(middle);
  Extent extent;
  Extent of_second;
  const auto build_first = [&] { extent = build(items.subspan(0, middle), cluster + 1); };
  const auto build_second = [&] { of_second = build(items.subspan(middle), here.emitter_or_second); };
  if (items.size() > ParallelCount) {
    parallel::invoke(build_first, build_second);
  } else {
    build_first();
    build_second();
  }
  extent.extend_by(of_second);
  here.bounds = {extent.box, extent.normals, static_cast<float>(extent.power)};
  return extent;
}

// Halves of clusters too large for one node come first, those of the most power before others: this takes the
// fewest levels on average. What is left of the node takes whole clusters in, since small nodes waste memory.
// The children stay in the order of the emitters, in which neighbours are close.
std::vector<std::uint32_t> LightTreeBuilder::children_of(std::uint32_t cluster) const {
  std::vector<std::uint32_t> children = {cluster};
  for (;;) {
    const std::size_t space = LightTree::Width - children.size();
    auto best = children.end();
    std::pair<bool, float> best_rank;
    for (auto child = children.begin(); child != children.end(); ++child) {
      const Cluster& candidate = clusters_[*child];
      const bool is_large = candidate.count > LightTree::Width;
      if (candidate.count == 1 || space == 0 || (!is_large && candidate.count > space + 1)) continue;
      const std::pair<bool, float> rank{
          is_large, is_large ? candidate.bounds.power : static_cast<float>(candidate.count)};
      if (best != children.end() && rank <= best_rank) continue;
      best = child;
      best_rank = rank;
    }
    if (best == children.end()) return children;
    const std::uint32_t first = *best + 1;
    *best = clusters_[*best].emitter_or_second;
    children.insert(best, first);
  }
}

void LightTreeBuilder::join(std::uint32_t cluster, LightTree::Place parent) {
  const std::vector<std::uint32_t> children = children_of(cluster);
  const auto index = static_cast<std::uint32_t>(tree_.nodes_.size());
  tree_.nodes_.emplace_back().parent = parent;
  if (index > 0) tree_.nodes_[parent.node].children[parent.child] = index;
  for (std::uint32_t i = 0; i < children.size(); ++i) {
    const Cluster& child = clusters_[children[i]];
    tree_.nodes_[index].bounds.set(static_cast<int>(i), child.bounds);
    if (child.count > 1) {
      join(children[i], {index, i});
    } else {
      tree_.nodes_[index].children[i] = child.emitter_or_second | LightTree::IsEmitter;
      tree_.place_of_emitter_[child.emitter_or_second] = {index, i};
    }
  }
}

LightTreeBuilder::Grid::Grid(Items items, int bucket_count) : count(bucket_count) {
  Box3f centres;
  for (const Item& item : items) centres.extendBy(doubled_centre(item.box));
  lower = centres.min;
  const Vec3f size = centres.max - centres.min;
  for (int axis = 0; axis < 3; ++axis)
    scale[axis] = size[axis] > 0 ? static_cast<float>(count) / size[axis] : 0;
}

int LightTreeBuilder::Grid::bucket(const Item& item, int axis) const {
  const float place = (item.box.min[axis] + item.box.max[axis] - lower[axis]) * scale[axis];
  return std::clamp(static_cast<int>(place), 0, count - 1);
}

// The cone of a bucket is centred on the mean of its normals, which takes a second pass.
LightTreeBuilder::Buckets LightTreeBuilder::fill(Items items, const Grid& grid) {
  Buckets buckets;
  for (auto& along : buckets) {
    for (Extent& bucket : along) bucket.normals.axis = Vec3f(0);
  }
  for (const Item& item : items) {
    for (int axis = 0; axis < 3; ++axis) {
      if (grid.scale[axis] == 0) continue;
      Extent& bucket = buckets[axis][grid.bucket(item, axis)];
      bucket.box.extendBy(item.box);
      bucket.normals.axis += item.normal;
      bucket.power += item.power;
      ++bucket.count;
    }
  }
  for (auto& along : buckets) {
    for (Extent& bucket : along) bucket.normals.axis.normalize();
  }
  for (const Item& item : items) {
    for (int axis = 0; axis < 3; ++axis) {
      if (grid.scale[axis] == 0) continue;
      Cone& normals = buckets[axis][grid.bucket(item, axis)].normals;
      normals.cosine = std::min(normals.cosine, normals.axis.dot(item.normal));
    }
  }
  return buckets;
}

// As in the paper, splits across the longer side of the box cost less: thin boxes are poor bounds.
LightTreeBuilder::Cut LightTreeBuilder::best_cut(const Buckets& buckets, const Grid& grid) {
  Cut best;
  best.cost = std::numeric_limits<double>::infinity();
  const double longest = 1 / double(std::min({grid.scale.x > 0 ? grid.scale.x : HUGE_VALF,
                                              grid.scale.y > 0 ? grid.scale.y : HUGE_VALF,
                                              grid.scale.z > 0 ? grid.scale.z : HUGE_VALF}));
  for (int axis = 0; axis < 3; ++axis) {
    if (grid.scale[axis] == 0) continue;
    std::array<double, MostBuckets> above{};
    Extent extent;
    for (int i = grid.count - 1; i > 0; --i) {
      extent.extend_by(buckets[axis][i]);
      above[i - 1] = extent.count > 0 ? extent.cost() : std::numeric_limits<double>::infinity();
    }
    extent = {};
    for (int i = 0; i + 1 < grid.count; ++i) {
      extent.extend_by(buckets[axis][i]);
      if (extent.count == 0) continue;
      const double cost = (extent.cost() + above[i]) * longest * double(grid.scale[axis]);
      if (cost < best.cost) best = {axis, i, cost};
    }
  }
  return best;
}

/// Partitions the items, and returns the size of the first part: at least one, and not all.
std::size_t LightTreeBuilder::partition(Items items) {
  if (items.size() == 2) return 1;
  const int count = static_cast<int>(std::min<std::size_t>(items.size(), MostBuckets));
  const Grid grid(items, count);
  const Cut cut = best_cut(fill(items, grid), grid);
  // All at one position: any halves will do.
  if (cut.axis < 0) return items.size() / 2;
  const auto middle = std::partition(items.begin(), items.end(), [&](const Item& item) {
    return grid.bucket(item, cut.axis) <= cut.bucket;
  });
  return static_cast<std::size_t>(middle - items.begin());
}

}  // namespace transport
