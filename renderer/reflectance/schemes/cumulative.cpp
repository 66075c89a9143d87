#include "renderer/reflectance/schemes/cumulative.h"

#include <cmath>
#include <utility>

namespace reflectance {
namespace {

struct Farthest {
  std::size_t index = 0;
  float distance = 0;
};

/// Finds the point between two others that is farthest from the line between these.
Farthest farthest(std::span<const float> x, std::span<const float> y, std::size_t first, std::size_t last) {
  const float slope = (y[last] - y[first]) / (x[last] - x[first]);
  Farthest found;
  for (std::size_t i = first + 1; i < last; ++i) {
    const float distance = std::abs(y[i] - (y[first] + slope * (x[i] - x[first])));
    if (distance > found.distance) found = {i, distance};
  }
  return found;
}

}  // namespace

std::vector<std::uint16_t> simplified(std::span<const float> x, std::span<const float> y, float tolerance) {
  std::vector<std::uint16_t> kept = {0};
  std::vector<std::size_t> ends = {x.size() - 1};  // of intervals still to be split, the nearest last
  std::size_t first = 0;
  while (!ends.empty()) {
    const Farthest between = farthest(x, y, first, ends.back());
    if (between.distance > tolerance) {
      ends.push_back(between.index);
      continue;
    }
    first = ends.back();
    ends.pop_back();
    kept.push_back(static_cast<std::uint16_t>(first));
  }
  return kept;
}

}  // namespace reflectance
