#include <cmath>

#include <gtest/gtest.h>

#include "tests/reflectance/albedo.h"

namespace {

using test::direction;

TEST(Beckmann, ShadowingIsSmiths) {
  reflectance::glsl::KajiyaFormula<double> formula;
  for (const double angle : {1.0, 30.0, 60.0, 85.0, 89.9}) {
    const Imath::V3d w(direction(angle, 30));
    const double s = std::hypot(0.2 * w.x, 0.5 * w.y);
    const double x = w.z / s;
    const double lambda = (std::exp(-x * x) / (x * std::sqrt(M_PI)) - std::erfc(x)) / 2;
    EXPECT_NEAR(formula.smith_over_cosine(w, 0.2, 0.5) * w.z, 1 / (1 + lambda), 1e-12);
  }
}

TEST(Kajiya, IsItsClosedForm) {
  const auto u = direction(40, 10);
  const auto v = direction(25, 170);
  const auto h = (u + v).normalized();
  const double tan2 = (h.x / 0.4) * (h.x / 0.4) + (h.y / 0.1) * (h.y / 0.1);
  const double facets = std::exp(-tan2 / (h.z * h.z)) / (M_PI * 0.4 * 0.1 * std::pow(h.z, 4));
  reflectance::glsl::KajiyaFormula<float> formula;
  const double expected =
      facets / 4 * formula.smith_over_cosine(u, 0.4F, 0.1F) * formula.smith_over_cosine(v, 0.4F, 0.1F);
  EXPECT_NEAR(evaluate(test::brdf_of("kajiya sigma=0.2 taux=1 tauy=4"), u, v).x, expected, 1e-5 * expected);
}

TEST(Kajiya, MattersByRatiosAlone) {
  const auto u = direction(40, 10);
  const auto v = direction(25, 170);
  EXPECT_EQ(evaluate(test::brdf_of("kajiya sigma=0.25 taux=1 tauy=2"), u, v),
            evaluate(test::brdf_of("kajiya sigma=256 taux=1024 tauy=2048"), u, v));
}

TEST(Kajiya, ConservesEnergyAtAllAngles) {
  for (const char* surface :
       {"sigma=0.2 taux=1 tauy=4", "sigma=1 taux=1 tauy=1", "sigma=0.05 taux=1 tauy=1"}) {
    for (const double angle : {0.0, 40.0, 70.0, 85.0, 89.0})
      EXPECT_LT(test::albedo(std::string("kajiya ") + surface, angle), 1.0005) << surface << angle;
  }
  EXPECT_NEAR(test::albedo("kajiya sigma=0.05 taux=1 tauy=1", 0), 1, 1e-3);
}

}  // namespace
