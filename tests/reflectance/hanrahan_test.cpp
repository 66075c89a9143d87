#include <cmath>

#include <gtest/gtest.h>

#include "tests/reflectance/albedo.h"

namespace {

using test::albedo;
using test::direction;

// Isotropic scattering without a surface is the Lommel-Seeliger law, whose albedo has a closed form.
TEST(Hanrahan, WithoutSurfaceIsLommelAndSeeliger) {
  const std::string layer = "hanrahan nreal=1 g=0 albedo=1 depth=1000000 ks=1 kd=0";
  for (const double angle : {0.0, 45.0, 80.0}) {
    const double c = std::cos(angle * M_PI / 180);
    EXPECT_NEAR(albedo(layer, angle), (1 - c * std::log((1 + c) / c)) / 2, 1e-4);
  }
}

TEST(Hanrahan, ScattersAtMostItsAlbedo) {
  for (const char* g : {"-0.9", "0", "0.9"}) {
    for (const double angle : {0.0, 60.0, 89.0, 89.99})
      EXPECT_LT(albedo(std::string("hanrahan nreal=1 albedo=0.7 kd=0 g=") + g, angle), 0.7) << g << angle;
  }
  for (const double angle : {0.0, 60.0, 85.0})
    EXPECT_LT(albedo("hanrahan g=0 albedo=1 ks=0 kd=0", angle), 0.5);
}

TEST(Hanrahan, ThinLayersScatterInProportionToTheirDepth) {
  const auto u = direction(20, 10);
  const auto v = direction(50, 100);
  const auto value = [&](const std::string& depth) {
    return evaluate(test::brdf_of("hanrahan ks=0 kd=0 depth=" + depth), u, v).x;
  };
  EXPECT_EQ(value("0"), 0);
  EXPECT_NEAR(value("1e-6") / value("2e-6"), 0.5, 1e-5);
  EXPECT_NEAR(value("10") / value("1000000"), 1, 1e-6);
}

TEST(Hanrahan, TransmittanceIsWhatFresnelLeaves) {
  reflectance::glsl::HanrahanFormula<double> formula;
  for (const double n : {1.0, 1.0001, 1.4, 10.0, 100.0}) {
    for (const double c : {1.0, 0.7, 0.1, 1e-3})
      EXPECT_NEAR(formula.transmittance(c, n), 1 - formula.fresnel(c, n, 0), 1e-12);
    EXPECT_GT(formula.transmittance(1e-9, n), 0);
  }
}

TEST(Hanrahan, PhaseFunctionIsHenyeyAndGreensteins) {
  reflectance::glsl::HanrahanFormula<double> formula;
  const Imath::V3d u(direction(20, 10));
  const Imath::V3d v(direction(50, 100));
  for (const double g : {-0.9, -0.3, 0.0, 0.3, 0.9}) {
    const double expected = (1 - g * g) / (4 * M_PI * std::pow(1 + g * g + 2 * g * u.dot(v), 1.5));
    EXPECT_NEAR(formula.henyey_greenstein(u, v, g), expected, 1e-6 * expected);
  }
}

TEST(Fresnel, HasItsKnownValues) {
  reflectance::glsl::HanrahanFormula<double> formula;
  EXPECT_NEAR(formula.fresnel(1, 1.5, 0), 0.04, 1e-12);
  EXPECT_NEAR(formula.fresnel(1, 0.617, 2.63), (0.383 * 0.383 + 2.63 * 2.63) / (1.617 * 1.617 + 2.63 * 2.63),
              1e-12);
  EXPECT_NEAR(formula.fresnel(1e-9, 1.5, 0), 1, 1e-6);
  EXPECT_EQ(formula.fresnel(0.3, 1, 0), 0);
  EXPECT_EQ(formula.fresnel(1, 0, 0), 1);
  EXPECT_NEAR(formula.fresnel(0.3, 0.5, 0), 1, 1e-12) << "total reflection";
  // At Brewster's angle only half of the light, polarised, is reflected.
  const double c = 1 / std::sqrt(1 + 1.5 * 1.5);
  EXPECT_NEAR(formula.fresnel(c, 1.5, 0), std::pow((1.5 * 1.5 - 1) / (1.5 * 1.5 + 1), 2) / 2, 1e-12);
}

}  // namespace
