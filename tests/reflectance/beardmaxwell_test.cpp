#include <gtest/gtest.h>

#include "tests/reflectance/albedo.h"

namespace {

using test::albedo;

TEST(BeardMaxwell, OfTheThesisTable55HasTheAlbedoOfTheReference) {
  const std::string gold = "beardmaxwell omega=1 tau=0 nreal=0.37 nimag=2.82 Rs=0.4 Rd=0.75 Rv=0.5";
  EXPECT_NEAR(albedo(gold, 0), 1.57, 0.005);
  EXPECT_NEAR(albedo(gold, 80), 2.45, 0.005);
  EXPECT_NEAR(albedo(gold, 89), 5.1, 0.05);
}

TEST(BeardMaxwell, VolumeReflectsItsFactorInCommonUnits) {
  const std::string volume = "beardmaxwell Rs=0 Rd=0 Rv=0.5";
  EXPECT_NEAR(albedo(volume, 0), 4 * (1 - std::log(2)) * 0.5, 1e-5);
  EXPECT_NEAR(albedo(volume, 89.99), 4 * 0.5, 0.01);
  const reflectance::Vec3f normal(0, 0, 1);
  EXPECT_FLOAT_EQ(evaluate(test::brdf_of(volume), normal, normal).x, 0.5F / reflectance::Pi);
}

// Tests all three branches of its scale. At u = v = h, f is F D / (4 cos^2), and the integral of D cos over h
// is 1.
TEST(BeardMaxwell, FacetsAreNormalised) {
  for (const char* sigma : {"0.01", "0.05", "0.3", "0.94", "0.95", "1", "1.04", "1.05", "3", "10"}) {
    const auto brdf =
        test::brdf_of(std::string("beardmaxwell nreal=0 Rd=0 Rv=0 tau=1000000 omega=1000000 sigma=") + sigma);
    const auto integrand = [&](const reflectance::Vec3f& h) {
      const double z = h.z;
      return 4 * z * z * evaluate(brdf, h, h).x * z;
    };
    const statistics::Quadrature quadrature(integrand, {0, 0, 1}, 1e-8);
    EXPECT_NEAR(quadrature.over_hemisphere(), 1, 2e-4) << sigma;
  }
}

TEST(BeardMaxwell, ObscurationVanishesAtTheMirrorDirection) {
  const auto u = test::direction(50, 10);
  const auto v = reflectance::mirrored(u);
  EXPECT_EQ(evaluate(test::brdf_of("beardmaxwell omega=0.01"), u, v),
            evaluate(test::brdf_of("beardmaxwell omega=100"), u, v));
}

}  // namespace
