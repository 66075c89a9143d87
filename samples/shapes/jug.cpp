#include <algorithm>
#include <cmath>
#include <numbers>

#include "samples/shapes/shape.h"

namespace shape {
namespace {

constexpr double HalfTurn = std::numbers::pi;

/// Distance from the axis and height, from the middle of the bottom over the rim to the middle inside.
V3d profile(double along) {
  static const std::vector<V3d> points = {
      {0, 0.015, 0},    {0.13, 0.01, 0},  {0.25, 0, 0},     {0.29, 0.03, 0},   {0.31, 0.1, 0},
      {0.38, 0.22, 0},  {0.43, 0.36, 0},  {0.42, 0.52, 0},  {0.34, 0.67, 0},   {0.26, 0.79, 0},
      {0.24, 0.9, 0},   {0.27, 1, 0},     {0.315, 1.06, 0}, {0.312, 1.075, 0}, {0.29, 1.07, 0},
      {0.25, 1.01, 0},  {0.215, 0.9, 0},  {0.235, 0.79, 0}, {0.315, 0.67, 0},  {0.395, 0.52, 0},
      {0.405, 0.36, 0}, {0.355, 0.22, 0}, {0.26, 0.1, 0},   {0.13, 0.05, 0},   {0, 0.04, 0},
  };
  return curve_through(points, along);
}

/// A surface of revolution about the y axis, drawn out to a lip at +x.
V3d vessel(double along, double around) {
  const V3d at = profile(along);
  const double aside = std::remainder(around, 2 * HalfTurn);
  const double lip = smooth_step(0.85, 1.07, at.y) * std::exp(-std::pow(aside / 0.4, 2));
  const double radius = at.x * (1 + 0.42 * lip);
  return {radius * std::cos(around), at.y + 0.03 * lip, -radius * std::sin(around)};
}

/// From the neck to the belly at -x. Its ends are inside the wall.
V3d handle_curve(double along) {
  static const std::vector<V3d> points = {{-0.25, 0.97, 0}, {-0.42, 1.0, 0},  {-0.58, 0.93, 0},
                                          {-0.64, 0.76, 0}, {-0.58, 0.58, 0}, {-0.41, 0.43, 0}};
  return curve_through(points, along);
}

double handle_radius(double along, double around) {
  const double to_end = std::clamp(std::min(along, 1 - along) / 0.02, 0.0, 1.0);
  const double flare = 1 + 0.35 * std::pow(2 * along - 1, 4);
  const double flat = 1 + 0.25 * std::pow(std::sin(around), 2);
  return 0.04 * flare * flat * std::sqrt(to_end * (2 - to_end));
}

}  // namespace

grf::Mesh jug(int triangles) {
  Builder builder;
  builder.add(vessel, 0.85 * triangles, 1.3);
  builder.add(tube(handle_curve, handle_radius, [](double) { return V3d(0, 0, 1); }), 0.15 * triangles, 4);
  return builder.mesh();
}

}  // namespace shape
