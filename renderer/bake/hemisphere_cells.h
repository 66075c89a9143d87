#pragma once

#include <vector>

#include "grf/math.h"

namespace bake {

/// A partition of the hemisphere about z into any number of cells of equal cosine-weighted solid angle: rings
/// of equal-area cells of the disc below it (Beckers and Beckers 2012, "A general rule for disk and
/// hemisphere partition into equal-area cells").
class HemisphereCells {
 public:
  explicit HemisphereCells(int count);

  int count() const { return count_; }
  /// The cell that contains a direction; below the horizon, the nearest cell at the rim.
  int cell_of(const grf::Vec3f& direction) const;
  /// The unit direction of a cell's centre, by area.
  grf::Vec3f centre(int cell) const;

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

}  // namespace bake
