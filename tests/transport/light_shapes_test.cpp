// Spherical shapes of lights: their solid angles, and uniform sampling.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "renderer/transport/lights/spherical_rectangle.h"
#include "renderer/transport/lights/spherical_triangle.h"
#include "renderer/transport/sobol.h"
#include "tests/statistics/chi_square.h"
#include "tests/transport/solid_angles.h"

namespace {

using grf::Vec2d;
using grf::Vec2f;
using grf::Vec3d;
using test::Vec3l;
using transport::SphericalParallelogram;
using transport::SphericalRectangle;
using transport::SphericalTriangle;

enum class Kind { Triangle, Parallelogram, Rectangle };

/// A shape relative to the origin.
struct Shape {
  Kind kind = Kind::Triangle;
  Vec3d corner, edge1, edge2;

  template <class Use>
  auto with(const Use& use) const {
    if (kind == Kind::Triangle) return use(SphericalTriangle(corner, edge1, edge2));
    if (kind == Kind::Parallelogram) return use(SphericalParallelogram(corner, edge1, edge2));
    return use(SphericalRectangle(corner, edge1, edge2));
  }
  double solid_angle() const {
    return with([](const auto& shape) { return double(shape.solid_angle()); });
  }
  Vec2d sample(const Vec2f& xi) const {
    return with([&](const auto& shape) { return shape.sample(xi); });
  }

  /// The amplification of rounding errors: edge-on the distance of the plane is a difference of larger
  /// numbers, and the corners of a thin shape that the origin touches are in opposite directions.
  double condition() const {
    const Vec3d normal = edge1.cross(edge2).normalized();
    double condition = corner.length() / std::abs(normal.dot(corner));
    const Vec3d corners[] = {corner, corner + edge1, corner + edge2, corner + edge1 + edge2};
    for (const Vec3d& a : corners) {
      for (const Vec3d& b : corners) {
        const Vec3d sum = a.normalized() + b.normalized();
        condition = std::max(condition, 1 / std::max(sum.dot(sum), 1e-30));
      }
    }
    return condition;
  }

  /// The solid angle of the part with u and v in these ranges.
  double reference(double u0 = 0, double u1 = 1, double v0 = 0, double v1 = 1) const {
    const Vec3l e1(edge1);
    const Vec3l e2(edge2);
    const Vec3l at = Vec3l(corner) + e1 * (long double)(u0) + e2 * (long double)(v0);
    const Vec3l side1 = e1 * (long double)(u1 - u0);
    const Vec3l side2 = e2 * (long double)(v1 - v0);
    if (kind == Kind::Triangle && u1 + v1 > 1 + 1e-12) return test::solid_angle_of_triangle(at, side1, side2);
    return test::solid_angle_of_parallelogram(at, side1, side2);
  }
};

std::ostream& operator<<(std::ostream& out, const Shape& shape) {
  return out << "kind " << int(shape.kind) << " corner " << shape.corner << " edges " << shape.edge1 << " "
             << shape.edge2 << " solid angle " << shape.reference();
}

TEST(SolidAngle, OfAnOctantIsHalfPi) {
  const SphericalTriangle octant({1, 0, 0}, {-1, 0, 1}, {-1, 1, 0});
  EXPECT_NEAR(octant.solid_angle(), std::numbers::pi / 2, 1e-6);
  EXPECT_EQ(SphericalTriangle({1, 0, 0}, {-1, 1, 0}, {-1, 0, 1}).solid_angle(), 0);  // from behind
}

TEST(SolidAngle, OfASquareOverItsCentre) {
  for (const double half : {1e-7, 1e-3, 0.1, 1.0, 30.0, 1e6}) {
    // Front down, a distance of 1 above.
    const Vec3d corner(-half, -half, 1);
    const Vec3d e1(0, 2 * half, 0);
    const Vec3d e2(2 * half, 0, 0);
    const double expected = 4 * std::asin(half * half / (1 + half * half));
    EXPECT_NEAR(SphericalRectangle(corner, e1, e2).solid_angle(), expected, 1e-6 * expected);
    EXPECT_NEAR(SphericalParallelogram(corner, e1, e2).solid_angle(), expected, 1e-6 * expected);
    const double half_of_it = SphericalTriangle(corner, e1, e2).solid_angle();
    EXPECT_NEAR(half_of_it, expected / 2, 1e-6 * expected);
  }
}

TEST(SolidAngle, FollowsLHuilier) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    Vec3d p[3];
    for (Vec3d& corner : p) corner = Vec3d(number(random), number(random), number(random));
    const double volume = (p[1] - p[0]).cross(p[2] - p[0]).dot(p[0]);
    if (std::abs(volume) < 0.01) continue;
    if (volume > 0) std::swap(p[1], p[2]);
    const double expected = test::solid_angle_by_sides(Vec3l(p[0]), Vec3l(p[1]), Vec3l(p[2]));
    EXPECT_NEAR(SphericalTriangle(p[0], p[1] - p[0], p[2] - p[0]).solid_angle(), expected, 2e-6 * expected);
  }
}

/// Shapes of all kinds, sizes and orientations that face the origin.
rc::Gen<Shape> any_shape() {
  return rc::gen::exec([] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> number(0, 1);
    const auto vector = [&] { return Vec3d(normal(random), normal(random), normal(random)); };
    const auto magnitude = [&](double least, double most) {
      return std::exp(std::log(least) + number(random) * (std::log(most) - std::log(least)));
    };
    Shape shape;
    shape.kind = static_cast<Kind>(random() % 3);
    const Vec3d x = vector().normalized();
    const Vec3d y = x.cross(vector()).normalized();
    const double size = magnitude(1e-6, 1e6);
    const double slenderness = random() % 2 == 0 ? 1 : magnitude(1e-6, 1);
    const double slant = shape.kind == Kind::Rectangle || random() % 2 == 0 ? 0 : 5 * normal(random);
    shape.edge1 = x * size;
    shape.edge2 = (y + x * slant) * (size * slenderness);
    // A point over or beside the shape, from touching to far.
    const double height = size * magnitude(1e-9, 1e6);
    const double spread = random() % 2 == 0 ? 1 : magnitude(1, 1e6);
    shape.corner = -shape.edge1 * (number(random) * spread) - shape.edge2 * (number(random) * spread) -
                   x.cross(y) * height;
    return shape;
  });
}

RC_GTEST_PROP(LightShapes, HaveTheirSolidAngle, ()) {
  const Shape shape = *any_shape();
  RC_LOG() << shape << '\n';
  const double expected = shape.reference();
  RC_ASSERT(std::abs(shape.solid_angle() - expected) <= (1e-6 + 1e-15 * shape.condition()) * expected);
}

RC_GTEST_PROP(LightShapes, AreSampledWithin, ()) {
  const Shape shape = *any_shape();
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  for (std::uint32_t i = 0; i < 64; ++i) {
    const Vec2d at = shape.sample(transport::sobol_point(i, seed).xy());
    RC_ASSERT(at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1);
    if (shape.kind == Kind::Triangle) RC_ASSERT(at.x + at.y <= 1 + 1e-12);
  }
  for (const float x : {0.0F, 0x1p-24F, 0.5F, 1 - 0x1p-24F}) {
    for (const float y : {0.0F, 0x1p-24F, 0.5F, 1 - 0x1p-24F}) {
      const Vec2d at = shape.sample({x, y});
      RC_ASSERT(at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1);
    }
  }
}

// Tests the map itself, without statistics: a fraction xi.x of the solid angle lies on one side of the
// point's line, and within a thin wedge along this line a fraction xi.y lies before the point.
RC_GTEST_PROP(LightShapes, AreCoveredEvenly, ()) {
  const Shape shape = *any_shape();
  const Vec2f xi = transport::sobol_point(*rc::gen::inRange(0U, 1U << 20), 3).xy();
  const Vec2d at = shape.sample(xi);
  const double whole = shape.reference();
  RC_LOG() << shape << " xi " << xi << " at " << at << '\n';
  double share = 0;
  if (shape.kind == Kind::Rectangle && shape.solid_angle() >= 1e-8F) {
    share = shape.reference(0, at.x) / whole;
  } else {
    const Vec3l p(shape.corner);
    const Vec3l e1(shape.edge1);
    const Vec3l e2(shape.edge2);
    const Vec3l to_point = e1 * (long double)(at.x) + e2 * (long double)(at.y);
    if (shape.kind == Kind::Triangle) {
      // The line from the pivot through the point, up to the edge.
      share = test::solid_angle_of_triangle(p, e1, to_point / (long double)(at.x + at.y)) / whole;
    } else if (at.x >= at.y) {
      share = test::solid_angle_of_triangle(p, e1, to_point / (long double)(at.x)) / whole;
    } else {
      share = 1 - test::solid_angle_of_triangle(p, to_point / (long double)(at.y), e2) / whole;
    }
  }
  RC_ASSERT(std::abs(share - double(xi.x)) < 1e-5 + 1e-13 * shape.condition());
}

struct ChiSquareCase {
  Shape shape;
  const char* what;
};

std::vector<ChiSquareCase> chi_square_cases() {
  std::vector<ChiSquareCase> cases;
  const Vec3d x(1, 0, 0);
  const Vec3d y(0, 1, 0);
  for (const Kind kind : {Kind::Triangle, Kind::Parallelogram, Kind::Rectangle}) {
    const Vec3d slanted = kind == Kind::Rectangle ? x : x + 0.7 * y;
    const auto add = [&](const Vec3d& corner, double along_y, double along_x, const char* what) {
      cases.push_back({{kind, corner, y * along_y, slanted * along_x}, what});
    };
    add({-0.5, -0.5, 0.7}, 1, 1, "near");
    add({3, 2, 0.5}, 2, 4, "low");
    add({-0.5, -0.3, 1e-3}, 1, 1, "touching");
    add({2, 3, 1e-7}, 1, 1, "edge-on");
    add({-3e5, -4e5, 1}, 1e6, 1e6, "huge");
    add({0.3, 0.4, 1}, 1e-6, 1e-6, "tiny");
    add({1e6, 2e6, 1e6}, 1, 1, "far");
    add({-0.5, 0.2, 0.1}, 1, 1e-5, "sliver");
  }
  return cases;
}

TEST(LightShapes, AreDrawnByTheirDensity) {
  constexpr int Cells = 8;
  constexpr int Samples = 40000;
  const auto cases = chi_square_cases();
  std::mt19937 random(7);
  std::uniform_real_distribution<float> number(0, 1 - 0x1p-24F);
  for (const auto& [shape, what] : cases) {
    const double whole = shape.solid_angle();
    std::vector<double> expectation;
    double sum = 0;
    for (int i = 0; i < Cells * Cells; ++i) {
      const int u = i / Cells;
      const int v = i % Cells;
      const bool outside = shape.kind == Kind::Triangle && u + v >= Cells;
      const double part = outside ? 0
                                  : shape.reference(double(u) / Cells, double(u + 1) / Cells,
                                                    double(v) / Cells, double(v + 1) / Cells);
      sum += part / whole;
      expectation.push_back(Samples * part / whole);
    }
    EXPECT_NEAR(sum, 1, 1e-5) << what << int(shape.kind);  // the integral of the pdf
    std::vector<double> counts(Cells * Cells);
    const auto cell_of = [](double place) { return std::min(static_cast<int>(place * Cells), Cells - 1); };
    for (int i = 0; i < Samples; ++i) {
      const float first = number(random);
      const Vec2d at = shape.sample({first, number(random)});
      counts[cell_of(at.x) * Cells + cell_of(at.y)] += 1;
    }
    EXPECT_GT(statistics::chi_square_p_value(expectation, counts),
              statistics::significance(static_cast<int>(cases.size())))
        << what << ' ' << int(shape.kind);
  }
}

// Continuity, which keeps samples of a Sobol' sequence well distributed on the light.
TEST(LightShapes, AreMappedContinuously) {
  for (const auto& [shape, what] : chi_square_cases()) {
    if (std::string(what) != "near" && std::string(what) != "tiny") continue;
    constexpr int Steps = 512;
    for (int i = 0; i < Steps; ++i) {
      for (const float other : {0.2F, 0.9F}) {
        const float a = static_cast<float>(i) / Steps;
        const float b = static_cast<float>(i + 1) / Steps - 0x1p-24F;
        EXPECT_LT((shape.sample({a, other}) - shape.sample({b, other})).length(), 0.02) << what;
        if (i == 0) continue;  // the pivot's corner is stretched without bound
        EXPECT_LT((shape.sample({other, a}) - shape.sample({other, b})).length(), 0.04) << what;
      }
    }
  }
}

}  // namespace
