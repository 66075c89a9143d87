#include <cmath>

#include <gtest/gtest.h>

#include "tests/reflectance/albedo.h"

namespace {

using reflectance::Vec3f;
using test::brdf_of;
using test::direction;

using GranierFormula = reflectance::glsl::GranierFormula<double>;

TEST(HalfPower, ReflectsOneAtNormalIncidence) {
  EXPECT_DOUBLE_EQ(GranierFormula().half_power_scale(0), 1 / M_PI);
  for (const double n : {0.0, 0.5, 1.0, 10.0, 300.0}) {
    const auto integrand = [&](const Vec3f& v) {
      return GranierFormula().half_power_scale(n) * GranierFormula().half_power({0, 0, 1}, Imath::V3d(v), n) *
             double(v.z);
    };
    EXPECT_NEAR(statistics::Quadrature(integrand, {0, 0, 1}, 1e-8).over_hemisphere(), 1, 1e-5) << n;
  }
}

TEST(Granier, BeamsInterfereBetweenTheirBounds) {
  for (const double order : {0.0, 0.25, 0.5, 3.0, 19.5, 50.0, 1e6}) {
    const double both = GranierFormula().two_beams(2, 3, order);
    EXPECT_GE(both, std::pow(std::sqrt(2) - std::sqrt(3), 2) - 1e-12);
    EXPECT_LE(both, std::pow(std::sqrt(2) + std::sqrt(3), 2) + 1e-12);
    const double shown = order <= 20 ? std::cos(2 * M_PI * order) : order < 100 ? 0.625 : 0;
    EXPECT_NEAR(both, 5 + 2 * shown * std::sqrt(6), 1e-9);
  }
  EXPECT_DOUBLE_EQ(GranierFormula().two_beams(2, 3, 1e6), 5) << "many fringes are their mean";
  EXPECT_NEAR(GranierFormula().two_beams(2, 2, 7.5), 0, 1e-25);
}

TEST(Granier, IsItsFormula) {
  const Vec3f u = direction(30, 20);
  const Vec3f v = direction(40, 190);
  const double n = 1.5;
  const Vec3f h = (u + v).normalized();
  const auto inside = [&](const Vec3f& w) {
    return Vec3f(w.x / 1.5F, w.y / 1.5F, static_cast<float>(std::sqrt(1 - (1 - w.z * w.z) / (n * n))));
  };
  const Vec3f h2 = (inside(u) + inside(v)).normalized();
  const auto schlick = [](double c) { return 0.04 + 0.96 * std::pow(1 - c, 5); };
  const auto scale = [](double e) { return (e + 2) * (e + 4) / (8 * M_PI * (std::exp2(-e / 2) + e)); };
  const double outer = 0.9 * schlick(u.dot(h)) * scale(40) * std::pow(h.z, 40);
  const double cosine = std::sin(0.1) * h2.x + std::cos(0.1) * h2.z;
  const double inner =
      0.7 * (1 - schlick(u.z)) * (1 - schlick(v.z)) * scale(30) * std::pow(cosine, 30) / (n * n);
  const double phase = 2 * M_PI * n * 300 * h.z / 525;
  const double expected = 0.2 / M_PI + outer + inner + 2 * std::cos(2 * phase) * std::sqrt(outer * inner);
  const auto brdf = brdf_of("granier nreal=1.5 d=300 n=40 m=30 tilt=0.1 ks=0.9 kt=0.7 kd=0.2");
  EXPECT_NEAR(evaluate(brdf, u, v).y, expected, 1e-4 * expected);
}

TEST(Granier, FilmOfNoThicknessIsInPhase) {
  const Vec3f u = direction(30, 20);
  const Vec3f v = direction(40, 190);
  const auto value = [&](const std::string& rest) {
    return evaluate(brdf_of("granier d=0 " + rest), u, v).x;
  };
  const float both = std::sqrt(value("kt=0")) + std::sqrt(value("ks=0"));
  EXPECT_NEAR(value(""), both * both, 1e-5F * both * both);
}

}  // namespace
