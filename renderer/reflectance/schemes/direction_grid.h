// Schemes with tables share grids of cells over spherical coordinates, with half vectors and the tabulated
// values.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/schemes/azimuth_rotation.h"

namespace reflectance {

/// Returns 1 - cos(theta) of a unit vector above the horizon, accurate near the normal.
inline float versine_of(const Vec3f& w) { return (w.x * w.x + w.y * w.y) / (1 + w.z); }

/// Returns the azimuth in turns, in [0, 1].
inline float turns_of(const Vec3f& w) {
  const float turns = std::atan2(w.y, w.x) / (2 * Pi);
  return turns < 0 ? turns + 1 : turns;
}

/// Returns theta in right angles, 0 to 1.
inline float right_angles_of(float versine) {
  return std::asin(std::min(1.0F, std::sqrt(versine / 2))) * (4 / Pi);
}

/// Cells of the hemisphere between evenly spaced angles theta (rows) and phi (columns). Points within a cell
/// are uniform in solid angle: in 1 - cos(theta) times phi.
class DirectionGrid {
 public:
  DirectionGrid() = default;
  DirectionGrid(std::size_t rows, std::size_t columns) : columns_(columns) {
    for (std::size_t i = 0; i <= rows; ++i) {
      const double sine = std::sin(Pi / 4 * static_cast<double>(i) / static_cast<double>(rows));
      versines_.push_back(i == rows ? 1 : static_cast<float>(2 * sine * sine));
    }
  }

  std::size_t rows() const { return versines_.size() - 1; }
  std::size_t columns() const { return columns_; }
  std::size_t bytes() const { return versines_.size() * sizeof(float); }

  /// Returns 1 - cos(theta) of the edges, from 0 to 1.
  const std::vector<float>& versines() const { return versines_; }

  std::size_t row_of(const Vec3f& w) const {
    const float versine = versine_of(w);
    const float place = right_angles_of(versine) * static_cast<float>(rows());
    std::size_t row = std::min(static_cast<std::size_t>(place), rows() - 1);
    while (row > 0 && versine < versines_[row]) --row;  // the angle is rounded; the edges decide
    while (row + 1 < rows() && versine >= versines_[row + 1]) ++row;
    return row;
  }
  std::size_t column_of(const Vec3f& w) const {
    return std::min(static_cast<std::size_t>(turns_of(w) * static_cast<float>(columns_)), columns_ - 1);
  }

  /// Returns the direction at a fraction, in 1 - cos(theta), from edge `row` to `row_end`, and at that
  /// (fractional) column.
  Vec3f direction(std::size_t row, std::size_t row_end, float fraction, float column) const {
    const float versine = versines_[row] + fraction * (versines_[row_end] - versines_[row]);
    const float sine = std::sqrt(versine * (2 - versine));
    return from_angles(1 - versine, sine, 2 * Pi * column / static_cast<float>(columns_));
  }

  /// Returns the solid angle of so many columns between two edges, in sr.
  float solid_angle(std::size_t row, std::size_t row_end, std::size_t columns) const {
    return (versines_[row_end] - versines_[row]) * 2 * Pi * static_cast<float>(columns) /
           static_cast<float>(columns_);
  }

  friend bool operator==(const DirectionGrid&, const DirectionGrid&) = default;

 private:
  std::vector<float> versines_;
  std::size_t columns_ = 0;
};

/// Points at which to evaluate a function in each cell of a grid: at least 2 x 2 per cell, and a minimal
/// number over all theta and phi, so that lobes narrower than a cell are not missed.
class CellPoints {
 public:
  CellPoints(const DirectionGrid& grid, std::size_t least_rows, std::size_t least_columns)
      : grid_(grid),
        down_(std::max<std::size_t>(2, least_rows / grid.rows())),
        across_(std::max<std::size_t>(2, least_columns / grid.columns())) {}

  std::size_t down() const { return down_; }
  std::size_t across() const { return across_; }

  Vec3f direction(std::size_t row, std::size_t column, std::size_t i, std::size_t k) const {
    const float fraction = (static_cast<float>(i) + 0.5F) / static_cast<float>(down_);
    const float turned =
        static_cast<float>(column) + (static_cast<float>(k) + 0.5F) / static_cast<float>(across_);
    return grid_.direction(row, row + 1, fraction, turned);
  }

 private:
  const DirectionGrid& grid_;
  std::size_t down_;
  std::size_t across_;
};

/// Returns the RGB mean of f cos(theta_v), an unnormalised pdf over v.
inline float scalar_of_direction(const Brdf& brdf, const Vec3f& u, const Vec3f& v) {
  return u.z > 0 && v.z > 0 ? mean(evaluate(brdf, u, v)) * v.z : 0;
}

/// Returns the same as an unnormalised pdf over h, which reflects u into v; the Jacobian is dv = 4 u.h dh.
inline float scalar_of_half(const Brdf& brdf, const Vec3f& u, const Vec3f& h) {
  const float cosine = u.dot(h);
  return cosine > 0 ? scalar_of_direction(brdf, u, reflected(u, h)) * 4 * cosine : 0;
}

}  // namespace reflectance
