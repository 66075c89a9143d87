// Projected directions (x, y) fill the unit disc, whose area is projected solid angle.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {

struct Box {
  double x0 = -1, y0 = -1, x1 = 1, y1 = 1;

  double area() const { return (x1 - x0) * (y1 - y0); }
};

/// Returns the bounding box of the part of a box inside the disc; its area is at most twice that part's if
/// the box has it. Section 5.3.3 of the thesis has eight cases by which corners are inside, and takes the
/// rim's height at the wrong corner where a box with two corners inside is left of or below the centre. The
/// rim is farthest out where the other coordinate is nearest to 0, which covers all cases.
inline Box inside_disc(const Box& box) {
  const double x = std::clamp(0.0, box.x0, box.x1);
  const double y = std::clamp(0.0, box.y0, box.y1);
  const double width = std::sqrt(std::max(0.0, 1 - y * y));
  const double height = std::sqrt(std::max(0.0, 1 - x * x));
  return {std::max(box.x0, -width), std::max(box.y0, -height), std::min(box.x1, width),
          std::min(box.y1, height)};
}

/// Returns the area of the part of the disc left of x and below y, both from -1 to 1.
inline double disc_area_below(double x, double y) {
  const auto half_segment = [](double t) { return (t * std::sqrt(1 - t * t) + std::asin(t)) / 2; };
  constexpr double Quarter = std::numbers::pi / 4;
  if (x * x + y * y <= 1) return Quarter + half_segment(x) + half_segment(y) + x * y;
  if (x < 0 && y < 0) return 0;
  if (x < 0) return 2 * (Quarter + half_segment(x));
  if (y < 0) return 2 * (Quarter + half_segment(y));
  return 2 * (half_segment(x) + half_segment(y));
}

/// Returns the area of the part of a box inside the disc; exactly 0 for a box outside.
inline double disc_area(const Box& box) {
  const double x = std::max(std::abs(box.x0), std::abs(box.x1));
  const double y = std::max(std::abs(box.y0), std::abs(box.y1));
  if (x * x + y * y <= 1) return box.area();
  const double nearest_x = std::clamp(0.0, box.x0, box.x1);
  const double nearest_y = std::clamp(0.0, box.y0, box.y1);
  if (nearest_x * nearest_x + nearest_y * nearest_y >= 1) return 0;
  return std::max(0.0, disc_area_below(box.x1, box.y1) - disc_area_below(box.x0, box.y1) -
                           disc_area_below(box.x1, box.y0) + disc_area_below(box.x0, box.y0));
}

}  // namespace reflectance
