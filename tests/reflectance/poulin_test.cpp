#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/reflectance/albedo.h"

namespace {

using reflectance::Vec3f;
using test::brdf_of;
using test::direction;

using Formula = reflectance::glsl::PoulinFormula<double>;
using Vec = Imath::V3d;

const std::vector<std::pair<double, double>> Surfaces = {
    {2, 0}, {2, 0.01}, {1, 0}, {0.1, 0}, {1.5, 0.9}, {2.5, 0.5}, {4, 0}, {100, 0.99}, {1e4, 0}};

TEST(Poulin, OfNoDistanceOrFullHeightIsAPlane) {
  for (const test::Pair& pair : test::direction_pairs(1000, 1)) {
    if (!(pair.u.z > 1e-12F && pair.v.z > 1e-12F)) continue;
    const double lobe = Formula().half_power_scale(30) * Formula().half_power(Vec(pair.u), Vec(pair.v), 30);
    const double expected = 0.5 / M_PI + 0.4 * lobe;
    for (const char* plane : {"d=0", "d=0 h=0.5", "h=1", "d=5 h=1", "d=1e-7"}) {
      const auto brdf = brdf_of(std::string("poulin n=30 ks=0.4 kd=0.5 ") + plane);
      EXPECT_NEAR(evaluate(brdf, pair.u, pair.v).x, expected, 1e-5 * expected) << plane;
    }
  }
}

// Cylinders that nearly coincide, are far apart or are covered by the floor tend to a plane.
TEST(Poulin, TendsToAPlaneAtItsLimits) {
  const Vec3f u = direction(40, 30);
  const Vec3f v = direction(20, 250);
  const float plane = evaluate(brdf_of("poulin d=0 n=30"), u, v).x;
  for (const char* nearly : {"d=1.1e-6", "d=0.001", "d=100000 h=0", "d=1000000 h=0", "d=2 h=0.9999999"})
    EXPECT_NEAR(evaluate(brdf_of(std::string("poulin n=30 ") + nearly), u, v).x, plane, 2e-3F * plane)
        << nearly;
}

// Visible arc and floor fill the view: their projected lengths sum to those of the plane.
TEST(Poulin, ArcAndFloorFillTheView) {
  for (const auto& [d, h] : Surfaces) {
    for (const double angle : {0.0, 30.0, 60.0, 80.0, 89.0, 89.999}) {
      for (const double phi : {0.0, 30.0, 90.0, 250.0, 270.0}) {
        const Vec w = Vec(direction(angle, phi));
        const auto seen = Formula().seen_from(w, d, h);
        const double psi = std::atan2(w.y, w.z);
        const double arc = std::hypot(w.y, w.z) * (std::sin(seen.high - psi) - std::sin(seen.low - psi));
        const double plane = w.z * (Formula().floor_width(d, h) - seen.hidden);
        EXPECT_NEAR((arc + plane) / (d * w.z), 1, 1e-6) << d << " " << h << " " << angle << " " << phi;
      }
    }
  }
}

// Compares both integrals over an arc with a fine midpoint rule.
TEST(Poulin, ArcIntegralsAreThoseOfTheIntegrand) {
  constexpr int Steps = 200000;
  for (const auto& [d, h] : Surfaces) {
    const Vec u(direction(50, 70));
    const Vec v(direction(35, 220));
    const double low = std::max(Formula().seen_from(u, d, h).low, Formula().seen_from(v, d, h).low);
    const double high = std::min(Formula().seen_from(u, d, h).high, Formula().seen_from(v, d, h).high);
    ASSERT_LT(low, high);
    for (const double n : {0.0, 0.5, 3.0, 100.0, 1e4}) {
      const Vec half = (u + v).normalized();
      double projected = 0;
      double lobe = 0;
      for (int i = 0; i < Steps; ++i) {
        const double a = low + (high - low) * (i + 0.5) / Steps;
        const Vec m(0, std::sin(a), std::cos(a));
        const double both = u.dot(m) * v.dot(m) * (high - low) / Steps;
        const double power = std::pow(std::max(0.0, m.dot(half)), n);
        projected += both;
        lobe += both * power;
      }
      EXPECT_NEAR(Formula().arc_projected(u, v, low, high), projected, 1e-9 * projected);
      EXPECT_NEAR(Formula().arc_lobe(u, v, low, high, n, false), lobe, 1e-7 * lobe + 1e-12) << d << " " << n;
    }
  }
}

TEST(Poulin, ConservesEnergy) {
  for (const auto& [d, h] : Surfaces) {
    for (const char* parts : {"n=0 ks=1 kd=0", "n=100 ks=1 kd=0", "n=100 ks=0 kd=1"}) {
      const auto brdf = brdf_of("poulin d=" + std::to_string(d) + " h=" + std::to_string(h) + " " + parts);
      for (const double angle : {0.0, 50.0, 80.0})
        EXPECT_LT(test::albedo(brdf, direction(angle, 70), 1e-6), 1.001) << d << " " << h << parts << angle;
    }
  }
}

// Tests cylinders that nearly coincide or are very far apart, floors at their feet and tops, and lobes of all
// widths.
TEST(Poulin, IsInFloatWhatItIsInDoubleAtItsLimits) {
  const std::vector<test::Pair> pairs = test::direction_pairs(40, 12);
  reflectance::Poulin poulin;
  for (const float d : {0.0F, 1e-7F, 1.1e-6F, 1e-4F, 0.01F, 1.0F, 1.9999999F, 2.0F, 2.0000002F, 1e3F, 1e6F}) {
    for (const float h : {0.0F, 1e-8F, 1e-4F, 0.5F, 0.9999F, 0.9999999F, 1.0F}) {
      for (const float n : {0.0F, 1e3F, 1e6F}) {
        poulin.d = d;
        poulin.h = h;
        poulin.n = n;
        std::vector<double> exact;
        for (const test::Pair& pair : pairs) exact.push_back(poulin.evaluate(Vec(pair.u), Vec(pair.v)).x);
        const double peak = *std::max_element(exact.begin(), exact.end());
        for (std::size_t i = 0; i < pairs.size(); ++i) {
          if (exact[i] < 1e-6 * peak) continue;
          ASSERT_NEAR(poulin.evaluate(pairs[i].u, pairs[i].v).x, exact[i], 1e-4 * exact[i])
              << d << " " << h << " " << n << pairs[i].u << pairs[i].v;
        }
      }
    }
  }
}

TEST(Poulin, DirectionsAlongTheCylindersSeeAllOfThem) {
  const auto seen = Formula().seen_from(Vec(direction(80, 0)), 2, 0);
  EXPECT_NEAR(seen.low, -M_PI / 2, 1e-6);
  EXPECT_NEAR(seen.high, M_PI / 2, 1e-6);
  EXPECT_EQ(seen.hidden, 0);
}

}  // namespace
