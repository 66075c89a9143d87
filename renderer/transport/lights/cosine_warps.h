#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "grf/math.h"

namespace transport {

/// Maps of the unit square to itself that make what a distribution of directions draws nearly follow the
/// cosine with a surface's normal as well: light from under the horizon, or from hardly over it, is then
/// hardly drawn. One map for each of some normals, constant in density over the cells of a grid (Hart, Pharr,
/// Mueller, Lopes, McGuire and Shirley 2020, "Practical product sampling by fitting and composing warps").
/// A share of each density is even, so that it is over 0 everywhere.
class CosineWarps {
 public:
  CosineWarps() = default;
  /// `direction_of` is what the distribution makes of a pair in [0,1).
  explicit CosineWarps(const std::function<grf::Vec3f(const grf::Vec2f&)>& direction_of);

  struct Warped {
    grf::Vec2f xi;
    float density = 1;  ///< there, over the unit square
  };

  /// For a surface with this unit normal. `xi` in [0,1), and so is the result.
  Warped warp(const grf::Vec3f& normal, const grf::Vec2f& xi) const;

  /// The density with which `warp` gives this pair.
  float density(const grf::Vec3f& normal, const grf::Vec2f& warped) const;

  std::size_t bytes() const { return tables_.capacity() * sizeof(Table); }

 private:
  static constexpr int Cells = 16;  ///< across and down
  struct Table {
    std::array<float, Cells> rows;  ///< cumulative shares up to and including each
    std::array<std::array<float, Cells>, Cells> columns;
  };

  static std::size_t table_of(const grf::Vec3f& normal);
  static Table table_for(const std::vector<std::vector<grf::Vec3f>>& directions, const grf::Vec3f& normal);

  std::vector<Table> tables_;
};

}  // namespace transport
