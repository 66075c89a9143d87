// Tests of the lit sphere in the plots of `bpt brdf plot`.
#include "renderer/command/lit_sphere.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/reflectance/brdf_cases.h"

namespace command {
namespace {

constexpr int Side = 60;
constexpr double Radius = 0.47 * Side;

image::Image sphere_of(const char* brdf) {
  return lit_sphere(reflectance::Reflector(test::brdf_of(brdf), reflectance::OwnScheme()), Side);
}

double distance_from_centre(int x, int y) { return std::hypot(x + 0.5 - Side / 2.0, y + 0.5 - Side / 2.0); }

TEST(LitSphere, IsADiscOnWhite) {
  const image::Image black = sphere_of("diffuse kd=0");
  double area = 0;
  for (int y = 0; y < Side; ++y) {
    for (int x = 0; x < Side; ++x) {
      const float value = black.at(x, y).x;
      const double distance = distance_from_centre(x, y);
      if (std::abs(distance - Radius) > 1) {
        EXPECT_EQ(value, distance < Radius ? 0 : 1) << x << " " << y;
      }
      area += 1 - static_cast<double>(value);
    }
  }
  EXPECT_NEAR(area, std::numbers::pi * Radius * Radius, 0.005 * area);
}

TEST(LitSphere, HasItsWindowAtTheUpperLeft) {
  const image::Image white = sphere_of("diffuse kd=0.8");
  const auto at = [&white](double right, double up) {
    return white.at(static_cast<int>(Side * (1 + right) / 2), static_cast<int>(Side * (1 - up) / 2)).x;
  };
  EXPECT_GT(at(-0.4, 0.4), 1.2F * at(0.4, 0.4));
  EXPECT_GT(at(-0.4, 0.4), 1.2F * at(-0.4, -0.4));
  EXPECT_GT(at(0.4, 0.4), at(0.4, -0.4));
  EXPECT_GT(at(-0.4, -0.4), at(0.4, -0.4));
}

}  // namespace
}  // namespace command
