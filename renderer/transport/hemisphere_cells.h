#pragma once

#include <vector>

#include "renderer/reflectance/geometry.h"

namespace transport {

using grf::Vec3f;

/// The hemisphere about z in cells of equal cosine-weighted solid angle: cells of equal area of the disc
/// below it, in rings (Beckers and Beckers 2012, "A general rule for disk and hemisphere partition into
/// equal-area cells"). There may be any number of them.
class HemisphereCells {
 public:
  explicit HemisphereCells(int count);

  int count() const { return count_; }
  /// The cell that a direction is in; for one below the horizon, the cell at the rim next to it.
  int cell_of(const Vec3f& direction) const;
  /// The unit direction in the middle of a cell, by area.
  Vec3f centre(int cell) const;

 private:
  struct Ring {
    int first = 0;  ///< cell
    int cells = 1;
    float inner2 = 0;  ///< squared radii
    float outer2 = 1;
  };

  int count_;
  std::vector<Ring> rings_;  ///< from the rim inwards
};

}  // namespace transport
