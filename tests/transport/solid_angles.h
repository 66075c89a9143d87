// Solid angles and irradiance by formulas that the renderer does not use, or in higher precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "grf/math.h"

namespace test {

using Vec3l = Imath::Vec3<long double>;

/// The solid angle by L'Huilier's theorem, for triangles that are not thin.
inline double solid_angle_by_sides(const Vec3l& p, const Vec3l& q, const Vec3l& r) {
  const auto side = [](const Vec3l& a, const Vec3l& b) {
    const Vec3l x = a / std::sqrt(a.dot(a));
    const Vec3l y = b / std::sqrt(b.dot(b));
    return 2 * std::atan2(std::sqrt((x - y).dot(x - y)), std::sqrt((x + y).dot(x + y)));
  };
  const long double a = side(p, q);
  const long double b = side(q, r);
  const long double c = side(r, p);
  const long double s = (a + b + c) / 2;
  const long double product =
      std::tan(s / 2) * std::tan((s - a) / 2) * std::tan((s - b) / 2) * std::tan((s - c) / 2);
  return static_cast<double>(4 * std::atan(std::sqrt(std::max(product, 0.0L))));
}

/// The solid angle of the triangle corner, corner + edge1, corner + edge2; thin and tiny ones too.
inline double solid_angle_of_triangle(const Vec3l& corner, const Vec3l& edge1, const Vec3l& edge2) {
  const Vec3l& p = corner;
  const Vec3l q = corner + edge1;
  const Vec3l r = corner + edge2;
  const long double a = std::sqrt(p.dot(p));
  const long double b = std::sqrt(q.dot(q));
  const long double c = std::sqrt(r.dot(r));
  const long double volume = std::abs(edge1.cross(edge2).dot(corner));
  return static_cast<double>(2 * std::atan2(volume, a * b * c + p.dot(q) * c + q.dot(r) * a + r.dot(p) * b));
}

inline double solid_angle_of_parallelogram(const Vec3l& corner, const Vec3l& edge1, const Vec3l& edge2) {
  return solid_angle_of_triangle(corner, edge1, edge2) +
         solid_angle_of_triangle(corner + edge1 + edge2, -edge1, -edge2);
}

/// The irradiance at the origin from a polygon of radiance 1, by Lambert's formula, clipped at the horizon of
/// the normal.
inline double lambert_irradiance(const std::vector<Vec3l>& corners, const Vec3l& normal) {
  std::vector<Vec3l> above;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3l& a = corners[i];
    const Vec3l& b = corners[(i + 1) % corners.size()];
    const long double height_a = a.dot(normal);
    const long double height_b = b.dot(normal);
    if (height_a >= 0) above.push_back(a);
    if (height_a * height_b < 0) above.push_back(a + (b - a) * (height_a / (height_a - height_b)));
  }
  long double sum = 0;
  for (std::size_t i = 0; i < above.size(); ++i) {
    const Vec3l& a = above[i];
    const Vec3l& b = above[(i + 1) % above.size()];
    const Vec3l cross = a.cross(b);
    const long double length = std::sqrt(cross.dot(cross));
    if (length > 0) sum += std::atan2(length, a.dot(b)) * cross.dot(normal) / length;
  }
  return static_cast<double>(std::abs(sum) / 2);
}

}  // namespace test
