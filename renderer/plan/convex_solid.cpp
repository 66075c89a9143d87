#include "renderer/plan/convex_solid.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace plan {
namespace {

using grf::Vec3d;

/// Returns an index per corner, equal for corners at the same position.
std::vector<std::size_t> places_of(std::span<const PlaneTriangle> triangles, double least) {
  // Much less than the rounding error of points that were computed twice: no ray finds a gap of that width.
  const double width = 1e-6 * least;
  std::vector<Vec3d> places;
  std::vector<std::size_t> indices;
  for (const PlaneTriangle& triangle : triangles) {
    for (const Vec3d& corner : triangle.corners) {
      const auto known = std::find_if(places.begin(), places.end(),
                                      [&](const Vec3d& place) { return (place - corner).length() <= width; });
      indices.push_back(static_cast<std::size_t>(known - places.begin()));
      if (known == places.end()) places.push_back(corner);
    }
  }
  return indices;
}

bool are_closed(std::span<const PlaneTriangle> triangles, double least) {
  using Edge = std::pair<std::size_t, std::size_t>;
  const std::vector<std::size_t> places = places_of(triangles, least);
  std::vector<Edge> edges, reverse;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    edges.emplace_back(places[i], places[next]);
    reverse.emplace_back(places[next], places[i]);
  }
  std::sort(edges.begin(), edges.end());
  std::sort(reverse.begin(), reverse.end());
  return edges == reverse && std::adjacent_find(edges.begin(), edges.end()) == edges.end();
}

}  // namespace

bool enclose_convex_solid(std::span<const PlaneTriangle> triangles, double least) {
  for (const PlaneTriangle& plane : triangles) {
    if (plane.normal == Vec3d(0)) return false;
    for (const PlaneTriangle& other : triangles) {
      for (const Vec3d& corner : other.corners) {
        if (plane.normal.dot(corner) - plane.height > least) return false;
      }
    }
  }
  return triangles.size() >= 4 && are_closed(triangles, least);
}

}  // namespace plan
