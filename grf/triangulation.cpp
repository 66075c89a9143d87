#include "grf/triangulation.h"

#include <algorithm>
#include <cmath>

#include "grf/polygon_sweep.h"

namespace grf {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Point = Imath::V2d;

Vec3d area_normal(std::span<const Vec3f> corners) {
  Vec3d normal(0);
  const Vec3d origin(corners[0]);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal += (Vec3d(corners[i]) - origin).cross(Vec3d(corners[i + 1]) - origin);
  }
  return normal;
}

/// Returns whether a polygon is planar up to float rounding. The normal is the area vector's.
bool is_planar(std::span<const Vec3f> corners, const Vec3d& normal) {
  const Vec3d origin(corners[0]);
  return std::all_of(corners.begin(), corners.end(), [&](const Vec3f& corner) {
    const double volume = (Vec3d(corner) - origin).dot(normal);
    return volume * volume <= 1e-10 * std::pow(normal.length2(), 1.5);
  });
}

/// Projects the corners along the axis in which the polygon is largest, counter-clockwise. This does not
/// round, so that collinear corners stay collinear.
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

/// Projects the corners along the polygon's own normal, counter-clockwise: projected along an axis, a polygon
/// that is not planar can intersect itself.
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

void fan(std::uint32_t corners, std::vector<Triangle>& triangles) {
  for (std::uint32_t i = 1; i + 1 < corners; ++i) triangles.push_back({0, i, i + 1});
}

/// Returns whether no triangle of a fan is flipped: the fan then covers a polygon that does not intersect
/// itself.
bool is_fan(std::span<const Point> points) {
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (orientation(points[0], points[i], points[i + 1]) < 0) return false;
  }
  return true;
}

/// Computes twice the total unsigned area of triangles.
double covered_area(std::span<const Point> points, std::span<const Triangle> triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) sum += std::abs(orientation(points[a], points[b], points[c]));
  return sum;
}

bool is_finite(std::span<const Point> points) {
  return std::all_of(points.begin(), points.end(),
                     [](const Point& point) { return std::isfinite(point.x) && std::isfinite(point.y); });
}

/// Replaces triangles by those of a sweep that cover less area. If the polygon intersects itself, if only by
/// rounding where it touches itself, another direction of the sweep may give a better result.
void cut_by_sweeps(std::span<Point> points, std::vector<Triangle>& best) {
  constexpr double Tolerance = 1 + 1e-6;
  double area = 0;
  for (const auto& [a, b, c] : best) area += orientation(points[a], points[b], points[c]);
  double covered = covered_area(points, best);
  std::vector<Triangle> triangles;
  for (int direction = 0; direction < 4 && covered > area * Tolerance; ++direction) {
    triangles.clear();
    const bool is_cut = triangulate_by_sweep(points, triangles);
    const double covered_now = covered_area(points, triangles);
    if (is_cut && covered_now < covered) {
      covered = covered_now;
      best.swap(triangles);
    }
    for (Point& point : points) point = {-point.y, point.x};
  }
}

}  // namespace

void triangulate(std::span<const Vec3f> corners, std::vector<Triangle>& triangles) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  if (count == 3) return fan(count, triangles);
  if (count == 4) {  // quadrilaterals are the most common polygons: they need no heap memory
    std::array<Point, 4> points;
    flatten(corners, points);
    if (is_fan(points)) return fan(count, triangles);
  }
  std::vector<Point> points(count);
  flatten(corners, points);
  if (is_fan(points) || !is_finite(points)) return fan(count, triangles);
  std::vector<Triangle> best;
  fan(count, best);
  cut_by_sweeps(points, best);
  triangles.insert(triangles.end(), best.begin(), best.end());
}

}  // namespace grf
