#include "grf/triangulation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/polygon_shapes.h"

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

double signed_area(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  return 0.5 * ((double(b.x) - a.x) * (double(c.y) - a.y) - (double(b.y) - a.y) * (double(c.x) - a.x));
}

double shoelace_area(const shapes::Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += signed_area(polygon[0], polygon[i], polygon[i + 1]);
  }
  return sum;
}

/// Each edge of the polygon is an edge of one triangle, and each other edge is one of two, in both
/// directions.
bool are_joined_as_a_polygon(const Triangles& triangles, std::size_t corners) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  const auto count = [&](std::size_t a, std::size_t b, int by) {
    const auto from = static_cast<std::uint32_t>(a), to = static_cast<std::uint32_t>(b);
    balance[{std::min(from, to), std::max(from, to)}] += from < to ? by : -by;
  };
  for (const auto& [a, b, c] : triangles) {
    count(a, b, 1);
    count(b, c, 1);
    count(c, a, 1);
  }
  for (std::size_t i = 0; i < corners; ++i) count(i, (i + 1) % corners, -1);
  return triangles.size() == corners - 2 &&
         std::all_of(balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 0; });
}

/// Checks shapes in the plane z = 0 that do not intersect themselves: no triangle is flipped, and their total
/// area is that of a closed form.
void expect_exact_cover(const shapes::Shape& shape) {
  SCOPED_TRACE(shape.name + ", " + std::to_string(shape.polygon.size()) + " corners");
  ASSERT_NEAR(shoelace_area(shape.polygon), shape.area, 1e-5 * shape.area);
  const Triangles triangles = triangles_of(shape.polygon);
  EXPECT_TRUE(are_joined_as_a_polygon(triangles, shape.polygon.size()));
  double covered = 0;
  for (const auto& [a, b, c] : triangles) {
    covered += std::abs(signed_area(shape.polygon[a], shape.polygon[b], shape.polygon[c]));
  }
  EXPECT_NEAR(covered, shape.area, 1e-5 * shape.area);
}

/// Computes the winding number of the polygon about a point, by its edges that cross the ray to the right.
int winding_number(const shapes::Polygon& polygon, const grf::Vec2d& point) {
  int winding = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3f& a = polygon[i];
    const Vec3f& b = polygon[(i + 1) % polygon.size()];
    if ((a.y <= point.y) == (b.y <= point.y)) continue;
    const double x = a.x + (point.y - a.y) / (double(b.y) - a.y) * (double(b.x) - a.x);
    if (x > point.x) winding += b.y > a.y ? 1 : -1;
  }
  return winding;
}

void expect_points_in_triangles(const shapes::Shape& shape) {
  SCOPED_TRACE(shape.name);
  const Triangles triangles = triangles_of(shape.polygon);
  grf::Box3f box;
  for (const Vec3f& corner : shape.polygon) box.extendBy(corner);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(box.min.x, box.max.x), y(box.min.y, box.max.y);
  for (int i = 0; i < 200; ++i) {
    const grf::Vec2d point(x(random), y(random));
    int found = 0;
    for (const auto& [a, b, c] : triangles) {
      found += winding_number({shape.polygon[a], shape.polygon[b], shape.polygon[c]}, point);
    }
    EXPECT_EQ(found, winding_number(shape.polygon, point)) << point.x << ", " << point.y;
  }
}

TEST(Triangulation, CoversHardShapes) {
  for (const std::uint32_t corners : {12U, 60U, 400U, 3000U}) {
    for (const shapes::Shape& shape : shapes::hard_shapes(corners)) expect_exact_cover(shape);
  }
  for (const shapes::Shape& shape : shapes::hard_shapes(100)) expect_points_in_triangles(shape);
}

TEST(Triangulation, CoversPolygonsThatTouchThemselves) {
  for (std::uint32_t seed = 1; seed <= 3000; ++seed) {
    expect_exact_cover(shapes::tree_of_squares(2 + seed % 40, seed));
    if (HasFailure()) return;
  }
  for (std::uint32_t seed = 1; seed <= 30; ++seed) expect_exact_cover(shapes::tree_of_squares(500, seed));
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    expect_points_in_triangles(shapes::tree_of_squares(30, seed));
  }
}

TEST(Triangulation, CoversTiltedPolygonsThatTouchThemselves) {
  for (std::uint32_t seed = 1; seed <= 500; ++seed) {
    shapes::Polygon polygon = shapes::tree_of_squares(2 + seed % 40, seed).polygon;
    for (Vec3f& corner : polygon) {
      corner = Vec3f(corner.x - corner.y, 2 * corner.x + 3 * corner.y, corner.y - 3 * corner.x);
    }
    SCOPED_TRACE(seed);
    ASSERT_TRUE(are_joined_as_a_polygon(triangles_of(polygon), polygon.size()));
    expect_cover(polygon);
  }
}

// Rounding makes polygons that touch themselves cross themselves, and a sweep in one direction then covers
// something twice in one of twelve. Where one direction does, three others mostly do not.
TEST(Triangulation, SeldomCoversTwiceWhereRoundingMakesPolygonsCross) {
  constexpr int Polygons = 1000;
  for (const double angle : {0.17, 0.5, 1.3}) {
    int twice = 0;
    for (std::uint32_t seed = 1; seed <= Polygons; ++seed) {
      const shapes::Shape shape = shapes::tree_of_squares(2 + seed % 40, seed);
      shapes::Polygon polygon = shape.polygon;
      for (Vec3f& corner : polygon) {
        corner = Vec3f(static_cast<float>(std::cos(angle) * corner.x - std::sin(angle) * corner.y),
                       static_cast<float>(std::sin(angle) * corner.x + std::cos(angle) * corner.y), 0);
      }
      double covered = 0;
      for (const auto& [a, b, c] : triangles_of(polygon)) {
        covered += std::abs(signed_area(polygon[a], polygon[b], polygon[c]));
      }
      twice += covered > shape.area * (1 + 1e-4);
    }
    EXPECT_LT(twice, Polygons / 25) << "turned by " << angle;
  }
}

TEST(Triangulation, SlitsAndHidesNoCornerOfPolygonsThatLookConvex) {
  // All corners turn to the left, but for the tip of the slit, which turns back.
  expect_exact_cover(
      {"slit", {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 2, 0}, {2, 2, 0}, {0, 2, 0}}, 16});
  // The notch is a corner that is written twice.
  expect_exact_cover({"notch", {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {2, 1, 0}, {0, 4, 0}}, 10});
}

TEST(Triangulation, KeepsConvexFacesAsFans) {
  const Triangles fan = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  EXPECT_EQ(triangles_of({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}}), fan);
  const Triangles quad = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(triangles_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), quad);
  EXPECT_EQ(triangles_of({{1, 1, 0}, {4, 0, 0}, {0, 0, 0}, {0, 4, 0}}).size(), 2U);
}

TEST(Triangulation, CutsWhatIsNoPolygonIntoAsManyTriangles) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> any(0, 1);
  shapes::Polygon crossing, line, point(50, Vec3f(1, 2, 3)), not_finite;
  for (int i = 0; i < 50; ++i) {
    crossing.emplace_back(any(random), any(random), any(random));
    line.emplace_back(any(random), 0.0F, 0.0F);
    not_finite.emplace_back(any(random), i % 7 == 0 ? NAN : any(random), 0.0F);
  }
  for (const shapes::Polygon& polygon : {crossing, line, point, not_finite}) {
    EXPECT_TRUE(are_joined_as_a_polygon(triangles_of(polygon), polygon.size()));
  }
}

}  // namespace
