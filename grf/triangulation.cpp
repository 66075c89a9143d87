#include "grf/triangulation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace grf {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Point = Imath::V2d;

double cross(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Vec3d area_normal(std::span<const Vec3f> corners) {
  Vec3d normal(0);
  const Vec3d origin(corners[0]);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal += (Vec3d(corners[i]) - origin).cross(Vec3d(corners[i + 1]) - origin);
  }
  return normal;
}

/// But for the rounding of float. The normal is the area's.
bool is_planar(std::span<const Vec3f> corners, const Vec3d& normal) {
  const Vec3d origin(corners[0]);
  return std::all_of(corners.begin(), corners.end(), [&](const Vec3f& corner) {
    const double volume = (Vec3d(corner) - origin).dot(normal);
    return volume * volume <= 1e-10 * std::pow(normal.length2(), 1.5);
  });
}

/// Puts the corners into the plane of an axis in which the polygon is largest, counter-clockwise. That rounds
/// nothing, so that corners on a line stay there.
void flatten_along_axis(std::span<const Vec3f> corners, const Vec3d& normal, std::span<Point> points) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
  }
  const int x = (axis + 1) % 3;
  const int y = (axis + 2) % 3;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double along_x = corners[i][x];
    points[i] = {normal[axis] < 0 ? -along_x : along_x, double(corners[i][y])};
  }
}

/// Puts the corners into the plane of the polygon's own normal, counter-clockwise: seen along an axis, a
/// polygon that is not planar can cross itself.
void flatten(std::span<const Vec3f> corners, std::span<Point> points) {
  const Vec3d normal = area_normal(corners);
  if (is_planar(corners, normal)) return flatten_along_axis(corners, normal, points);
  const Vec3d z = normal.normalized();
  const Vec3d axis = std::abs(z.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d x = axis.cross(z).normalized();
  const Vec3d y = z.cross(x);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d from_first = Vec3d(corners[i]) - Vec3d(corners[0]);
    points[i] = {from_first.dot(x), from_first.dot(y)};
  }
}

/// Clips ears off the polygon while it finds any; returns false if it gets stuck.
class EarClipper {
 public:
  explicit EarClipper(std::vector<Point> points) : points_(std::move(points)), left_(points_.size()) {
    std::iota(left_.begin(), left_.end(), 0U);
  }

  bool run(std::vector<Triangle>& triangles) {
    while (left_.size() > 3) {
      std::size_t ear = 0;
      while (ear < left_.size() && !is_ear(ear)) ++ear;
      if (ear == left_.size()) return false;
      triangles.push_back(triangle_at(ear));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return true;
  }

 private:
  Triangle triangle_at(std::size_t i) const {
    const std::size_t n = left_.size();
    return {left_[(i + n - 1) % n], left_[i], left_[(i + 1) % n]};
  }

  bool is_ear(std::size_t i) const {
    const Triangle t = triangle_at(i);
    const Point& a = points_[t[0]];
    const Point& b = points_[t[1]];
    const Point& c = points_[t[2]];
    if (cross(a, b, c) <= 0) return false;
    return std::none_of(left_.begin(), left_.end(), [&](std::uint32_t other) {
      const Point& p = points_[other];
      if (p == a || p == b || p == c) return false;
      return cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;
    });
  }

  std::vector<Point> points_;
  std::vector<std::uint32_t> left_;
};

void fan(std::uint32_t corners, std::vector<Triangle>& triangles) {
  for (std::uint32_t i = 1; i + 1 < corners; ++i) triangles.push_back({0, i, i + 1});
}

bool is_convex(std::span<const Point> points) {
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (cross(points[i], points[(i + 1) % n], points[(i + 2) % n]) < 0) return false;
  }
  return true;
}

}  // namespace

void triangulate(std::span<const Vec3f> corners, std::vector<Triangle>& triangles) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  if (count == 3) return fan(count, triangles);
  if (count == 4) {  // most polygons are: they do without memory from the heap
    std::array<Point, 4> points;
    flatten(corners, points);
    if (is_convex(points)) return fan(count, triangles);
  }
  std::vector<Point> points(count);
  flatten(corners, points);
  if (is_convex(points)) return fan(count, triangles);
  const std::size_t before = triangles.size();
  if (!EarClipper(std::move(points)).run(triangles)) {
    triangles.resize(before);
    fan(count, triangles);
  }
}

}  // namespace grf
