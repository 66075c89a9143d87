#include "renderer/reflectance/measurements/scattered_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <utility>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include "renderer/reflectance/merl_table.h"

namespace reflectance {
namespace {

using Imath::V3d;
using Point = boost::geometry::model::point<double, 4, boost::geometry::cs::cartesian>;

Point point_at(double a, double b, double c, double d) {
  Point point;
  point.set<0>(a);
  point.set<1>(b);
  point.set<2>(c);
  point.set<3>(d);
  return point;
}

/// Returns a point for a pair of directions, such that the distance between points is that of pairs: a disc
/// of half vectors, stretched towards the normal as the cells of MERL are, and a disc of the directions'
/// angle from h and twice their azimuth around it, which does not tell u from v. Isotropic pairs have no
/// azimuth of h, and at h = n none around it either.
Point point_of(const V3d& u, const V3d& v, bool is_isotropic) {
  const HalfAngles angles = half_angles(u, v);
  const double half = std::sqrt(std::max(0.0, angles.theta_half) * 2 / std::numbers::pi);
  const double difference = angles.theta_difference * 2 / std::numbers::pi;
  if (is_isotropic) {
    const double radius = half * difference;
    const double twice = 2 * angles.phi_difference;
    return point_at(half, difference, radius * std::cos(twice), radius * std::sin(twice));
  }
  const V3d h = u + v;
  const double azimuth = std::hypot(h.x, h.y) < 1e-12 ? 0 : std::atan2(h.y, h.x);
  const double twice = 2 * (angles.phi_difference + azimuth);
  return point_at(half * std::cos(azimuth), half * std::sin(azimuth), difference * std::cos(twice),
                  difference * std::sin(twice));
}

struct Entry {
  Rgb value;
  double weight = 1;
};

}  // namespace

class ScatteredTable::Index {
 public:
  struct Neighbour {
    double distance = 0;
    const Entry* entry = nullptr;
  };

  Index(const std::vector<Measurement>& measurements, bool is_isotropic) {
    std::vector<Item> items;
    entries_.reserve(measurements.size());
    items.reserve(measurements.size());
    for (const Measurement& one : measurements) {
      items.emplace_back(point_of(one.u, one.v, is_isotropic), static_cast<std::uint32_t>(entries_.size()));
      const double deviation = one.deviation > 0 ? 1 / (one.deviation * one.deviation) : 1;
      entries_.push_back({Rgb(one.value), one.weight * deviation});
    }
    tree_ = Tree(items);
  }

  /// Returns the nearest entries, the nearest one first.
  std::vector<Neighbour> near(const Point& point, std::size_t count) const {
    std::vector<Neighbour> found;
    const auto nearest = boost::geometry::index::nearest(point, static_cast<unsigned>(count));
    for (auto item = tree_.qbegin(nearest); item != tree_.qend(); ++item)
      found.push_back({boost::geometry::distance(point, item->first), &entries_[item->second]});
    std::sort(found.begin(), found.end(), [](const Neighbour& a, const Neighbour& b) {
      return std::pair(a.distance, a.entry) < std::pair(b.distance, b.entry);
    });
    return found;
  }

 private:
  using Item = std::pair<Point, std::uint32_t>;
  using Tree = boost::geometry::index::rtree<Item, boost::geometry::index::rstar<16>>;

  std::vector<Entry> entries_;
  Tree tree_;
};

ScatteredTable::ScatteredTable(const std::vector<Measurement>& measurements)
    : is_isotropic_(are_isotropic(measurements)),
      index_(std::make_shared<const Index>(measurements, is_isotropic_)) {}

Rgb ScatteredTable::linear(const V3d& u, const V3d& v) const {
  constexpr double Nothing = 1e-12;
  std::vector<Index::Neighbour> near = index_->near(point_of(u, v, is_isotropic_), NeighbourCount + 1);
  double reach = 2 * near.back().distance;
  if (near.size() > NeighbourCount) {
    reach = near.back().distance;
    near.pop_back();
  }
  const bool is_exact = near.front().distance <= Nothing;
  V3d sum(0);
  V3d plain_sum(0);
  double weights = 0;
  double plain_weights = 0;
  for (const Index::Neighbour& one : near) {
    if (is_exact && one.distance > Nothing) break;
    const double share = is_exact ? 1 : (reach - one.distance) / (reach * one.distance);
    const double weight = one.entry->weight * share * share;
    sum += weight * V3d(one.entry->value);
    weights += weight;
    plain_sum += V3d(one.entry->value);
    ++plain_weights;
  }
  // All are equally far, or have weight 0.
  if (!(weights > 0) || !std::isfinite(weights)) return Rgb(plain_sum / plain_weights);
  return Rgb(sum / weights);
}

Rgb ScatteredTable::nearest(const V3d& u, const V3d& v) const {
  return index_->near(point_of(u, v, is_isotropic_), 1).front().entry->value;
}

bool ScatteredTable::is_missing(const V3d& u, const V3d& v) const {
  return index_->near(point_of(u, v, is_isotropic_), 1).front().distance > LargestDistance;
}

}  // namespace reflectance
