#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "grf/math.h"

namespace transport {

/// Warps of the unit square that make a distribution of directions nearly proportional to the cosine with a
/// surface's normal as well, so that light from below or just above the horizon is hardly ever sampled. There
/// is one warp for each of some normals, with a piecewise-constant pdf over a grid (Hart, Pharr, Mueller,
/// Lopes, McGuire and Shirley 2020, "Practical product sampling by fitting and composing warps"). A fraction
/// of each pdf is uniform, so that it is over 0 everywhere.
class CosineWarps {
 public:
  CosineWarps() = default;
  /// `direction_of` maps a 2D sample in [0,1) to a direction of the distribution.
  explicit CosineWarps(const std::function<grf::Vec3f(const grf::Vec2f&)>& direction_of);

  struct Warped {
    grf::Vec2f xi;
    float pdf = 1;  ///< pdf of `xi` over the unit square
  };

  /// Warps for a surface with this unit normal. `xi` is in [0,1), and so is the result.
  Warped warp(const grf::Vec3f& normal, const grf::Vec2f& xi) const;

  /// The pdf with which `warp` returns this point.
  float pdf(const grf::Vec3f& normal, const grf::Vec2f& warped) const;

  std::size_t bytes() const { return tables_.capacity() * sizeof(Table); }

 private:
  static constexpr int Cells = 16;  ///< per side of the grid
  struct Table {
    std::array<float, Cells> rows;  ///< marginal CDF, up to and including each row
    std::array<std::array<float, Cells>, Cells> columns;
  };

  static std::size_t table_of(const grf::Vec3f& normal);
  static Table table_for(const std::vector<std::vector<grf::Vec3f>>& directions, const grf::Vec3f& normal);

  std::vector<Table> tables_;
};

}  // namespace transport
