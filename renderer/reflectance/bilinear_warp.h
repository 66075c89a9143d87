// Functions on the unit square that are tabulated at the nodes of a grid, for several parameters, as RGL's
// measured materials use them (Dupuy and Jakob 2018).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "grf/math.h"

namespace reflectance {

using grf::Vec2d;

/// The slices of a table, one per pair of parameters, that surround a pair of parameters, with the weights of
/// bilinear interpolation, which sum to 1.
struct SliceWeights {
  std::array<std::size_t, 4> slice = {};
  std::array<double, 4> weight = {1, 0, 0, 0};

  /// Interpolates a value per slice.
  template <class Value>
  double interpolate(const Value& value) const {
    double sum = 0;
    for (std::size_t i = 0; i < slice.size(); ++i) {
      if (weight[i] != 0) sum += weight[i] * value(slice[i]);
    }
    return sum;
  }
};

/// The parameters of a table's slices: each pair of one of `outer` and one of `inner`, which vary fastest.
/// Both are ascending and not empty.
class SliceGrid {
 public:
  SliceGrid() = default;
  SliceGrid(std::vector<float> outer, std::vector<float> inner);

  std::size_t slice_count() const { return outer_.size() * inner_.size(); }  ///< Returns the number of pairs.

  /// Returns the slices around a pair of parameters, which are clamped to the grid.
  SliceWeights around(double outer, double inner) const;

 private:
  std::vector<float> outer_ = {0};
  std::vector<float> inner_ = {0};
};

/// The nodes of a grid over the unit square: `width` along x, which varies fastest, and `height` along y. A
/// single node along an axis is a function that does not depend on it.
struct NodeGrid {
  std::size_t width = 1;
  std::size_t height = 1;

  std::size_t node_count() const { return width * height; }  ///< Returns the number of nodes.
};

/// A function on the unit square, interpolated bilinearly between nodes, in slices with one or more channels.
class BilinearTable {
 public:
  BilinearTable() = default;
  /// Takes the values in the order slice, channel, y, x.
  BilinearTable(const NodeGrid& grid, std::size_t channel_count, std::vector<float> values);

  std::size_t channel_count() const { return channel_count_; }  ///< Returns the number of channels.

  /// Evaluates a channel at a point, which is clamped to the unit square.
  double evaluate(const Vec2d& point, const SliceWeights& slices, std::size_t channel = 0) const;

  /// Returns a table whose channels are weighted sums of this one's: `weights` has a row per new channel.
  BilinearTable mixed(const std::vector<std::vector<double>>& weights) const;

 private:
  NodeGrid grid_;
  std::size_t channel_count_ = 1;
  std::vector<float> values_ = {0};
};

/// A point of a warp, with the probability density in the unit square there.
struct WarpedPoint {
  Vec2d point;
  double pdf = 0;
};

/// A probability density on the unit square, in slices with one density each, that warps uniform points to
/// points of that density: first y by the marginal density of rows, then x by the conditional density of the
/// row at y. It is continuous, and its inverse is exact. Densities and both cumulative distributions are
/// linear in the weights of the slices.
class BilinearWarp {
 public:
  BilinearWarp() = default;
  /// Takes at least 2 x 2 nodes and values >= 0 in the order slice, y, x, and normalises each slice. A slice
  /// of zeros is uniform.
  BilinearWarp(const NodeGrid& grid, const std::vector<float>& values);

  /// Warps a uniform point of the unit square.
  WarpedPoint sample(const Vec2d& uniform, const SliceWeights& slices) const;

  /// Returns the uniform point that is warped to `point`, with the density at `point`.
  WarpedPoint invert(const Vec2d& point, const SliceWeights& slices) const;

  double pdf(const Vec2d& point, const SliceWeights& slices) const;

 private:
  double density(std::size_t x, std::size_t y, const SliceWeights& slices) const;
  double row_cumulative(std::size_t x, std::size_t y, const SliceWeights& slices) const;
  double marginal(std::size_t y, const SliceWeights& slices) const;
  void add_slice(std::vector<double> densities);

  // In units of the grid: a cell has the area 1, and each slice the integral 1.
  NodeGrid grid_;
  std::vector<double> densities_;       ///< at the nodes
  std::vector<double> row_cumulative_;  ///< at the nodes, integrals of a row from its start
  std::vector<double> marginal_;        ///< at rows, integrals of the density below
};

}  // namespace reflectance
