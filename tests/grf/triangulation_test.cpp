#include "grf/triangulation.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace {

using grf::Vec3f;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles triangles_of(const std::vector<Vec3f>& corners) {
  Triangles triangles;
  grf::triangulate(corners, triangles);
  return triangles;
}

Vec3f doubled_area(const Vec3f& a, const Vec3f& b, const Vec3f& c) { return (b - a).cross(c - a); }

Vec3f polygon_area(const std::vector<Vec3f>& corners) {
  Vec3f sum(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += doubled_area(corners[0], corners[i], corners[i + 1]);
  return sum;
}

/// Triangles cover a polygon if none is turned over and their areas sum up to its own.
void expect_cover(const std::vector<Vec3f>& corners) {
  const Triangles triangles = triangles_of(corners);
  ASSERT_EQ(triangles.size(), corners.size() - 2);
  const Vec3f area = polygon_area(corners);
  float sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const float part = doubled_area(corners[a], corners[b], corners[c]).dot(area.normalized());
    EXPECT_GE(part, -1e-5F * area.length());
    sum += part;
  }
  EXPECT_NEAR(sum, area.length(), 1e-4F * area.length());
}

TEST(Triangulation, CoversConvexAndConcavePolygons) {
  expect_cover({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  expect_cover({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}});                        // an arrow head
  expect_cover({{0, 0, 0}, {0, 3, 0}, {1, 3, 0}, {1, 1, 0}, {3, 1, 0}, {3, 0, 0}});  // an L, clockwise
  expect_cover({{0, 0, 0}, {0, 0, 3}, {0, 1, 3}, {0, 1, 1}, {0, 3, 1}, {0, 3, 0}});  // the same, upright
}

RC_GTEST_PROP(Triangulation, CoversStarShapedPolygons, ()) {
  const auto radii = *rc::gen::suchThat(rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 100)),
                                        [](const auto& r) { return r.size() >= 3 && r.size() < 40; });
  std::vector<Vec3f> corners;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(radii.size());
    const double radius = radii[i];
    corners.emplace_back(static_cast<float>(radius * std::cos(angle)),
                         static_cast<float>(radius * std::sin(angle)),
                         static_cast<float>(0.3 * radius * std::cos(angle)));
  }
  expect_cover(corners);
}

TEST(Triangulation, CutsEvenPolygonsThatAreNone) {
  EXPECT_EQ(triangles_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).size(), 2U);  // no area
  EXPECT_EQ(triangles_of({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 2U);  // crosses itself
  EXPECT_EQ(triangles_of({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).size(), 3U);  // a point
}

}  // namespace
