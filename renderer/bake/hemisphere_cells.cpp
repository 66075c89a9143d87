#include "renderer/bake/hemisphere_cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/reflectance/geometry.h"

namespace bake {
namespace {

/// Returns the number of cells inside the outermost ring of this many, for cells about as long as wide.
int cells_inside(int count) {
  const double radius = std::sqrt(static_cast<double>(count)) - std::sqrt(std::numbers::pi);
  return radius <= 0 ? 0 : static_cast<int>(std::lround(radius * radius));
}

}  // namespace

HemisphereCells::HemisphereCells(int count) : count_(count) {
  for (int within = count; within > 0;) {
    const int inside = cells_inside(within);
    const auto share = [&](int cells) { return static_cast<float>(cells) / static_cast<float>(count); };
    rings_.push_back({inside, within - inside, share(inside), share(within)});
    within = inside;
  }
}

int HemisphereCells::cell_of(const grf::Vec3f& direction) const {
  const float radius2 = direction.z <= 0 ? 1 : direction.x * direction.x + direction.y * direction.y;
  const auto ring = std::find_if(rings_.begin(), rings_.end() - 1,
                                 [&](const Ring& candidate) { return radius2 >= candidate.inner2; });
  const float turn = std::atan2(direction.y, direction.x) / (2 * reflectance::Pi);
  const auto cells = static_cast<float>(ring->cells);
  const int cell = static_cast<int>((turn < 0 ? turn + 1 : turn) * cells);
  return ring->first + std::min(cell, ring->cells - 1);
}

grf::Vec3f HemisphereCells::centre(int cell) const {
  const auto ring = std::find_if(rings_.begin(), rings_.end() - 1,
                                 [&](const Ring& candidate) { return cell >= candidate.first; });
  if (ring->cells == 1) return {0, 0, 1};
  const float radius2 = (ring->inner2 + ring->outer2) / 2;
  const float turn = (static_cast<float>(cell - ring->first) + 0.5F) / static_cast<float>(ring->cells);
  return reflectance::from_angles(std::sqrt(1 - radius2), std::sqrt(radius2), 2 * reflectance::Pi * turn);
}

}  // namespace bake
