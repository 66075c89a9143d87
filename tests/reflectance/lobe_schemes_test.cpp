// The schemes that sample a lobe of given width: their exponents, the fraction of a lobe above the horizon,
// and the cosine mixture.
#include <cmath>

#include <boost/math/special_functions/beta.hpp>
#include <gtest/gtest.h>

#include "renderer/reflectance/coverage.h"
#include "renderer/reflectance/reflector.h"
#include "renderer/reflectance/schemes/lobe_over_horizon.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/scheme_cases.h"
#include "tests/statistics/quadrature.h"

namespace {

using reflectance::lobe_exponents;
using reflectance::Reflector;
using reflectance::Vec3f;

TEST(LobeOverHorizon, IsTheIncompleteBetaFunction) {
  for (const double n : {0.0, 0.3, 1.0, 2.0, 7.5, 100.0, 3000.0, 1e5, 1e6}) {
    const reflectance::LobeOverHorizon lobe(n);
    for (const double height : {90.0, 89.0, 60.0, 20.0, 5.0, 1.0, 0.1, 1e-3, 0.0}) {
      const double cosine = std::sin(height * std::numbers::pi / 180);
      const double expected = (1 + boost::math::ibeta(0.5, (n + 1) / 2, cosine * cosine)) / 2;
      EXPECT_NEAR(lobe.fraction(static_cast<float>(cosine)), expected, 1e-5) << n << " " << height;
    }
  }
}

TEST(LobeOverHorizon, IsTheLobesIntegral) {
  for (const double degrees : {0.0, 60.0, 85.0, 89.9}) {
    const Vec3f u = test::direction(degrees, 25);
    for (const float n : {0.5F, 20.0F, 300.0F}) {
      const statistics::Quadrature quadrature(
          [&](const Vec3f& v) { return double(reflectance::cosine_lobe_pdf(u, v, n)); },
          reflectance::mirrored(u), 1e-8);
      EXPECT_NEAR(quadrature.over_hemisphere(), reflectance::LobeOverHorizon(n).fraction(u.z), 3e-4);
    }
  }
}

TEST(LobeExponents, AreTheBrdfsOwn) {
  const auto about_mirror = [](const std::string& text) {
    return lobe_exponents(test::brdf_of(text)).value().about_mirror();
  };
  EXPECT_EQ(about_mirror("phong n=60"), 60);
  EXPECT_EQ(about_mirror("lewis n=60"), 60);
  EXPECT_EQ(about_mirror("lafortune n=60"), 60);
  EXPECT_EQ(about_mirror("blinn n=60"), 15);
  EXPECT_EQ(about_mirror("0.5 diffuse + 0.2 lewis n=60 + 0.3 phong n=30"), 30);
  const auto ashikhmin = lobe_exponents(test::brdf_of("ashikhmin ex=10 ey=90"));
  ASSERT_TRUE(ashikhmin);
  EXPECT_EQ(ashikhmin->x, 10);
  EXPECT_EQ(ashikhmin->y, 90);
  EXPECT_FALSE(lobe_exponents(test::brdf_of("diffuse")));
  EXPECT_FALSE(lobe_exponents(test::brdf_of("oren")));
}

TEST(LobeExponents, AreTakenByTheSchemesWhereNoneAreGiven) {
  const Vec3f u = test::direction(40, 25);
  const Vec3f v = test::direction(52, 200);
  const auto pdf = [&](const std::string& scheme, const std::string& brdf) {
    const reflectance::Brdf made = test::brdf_of(brdf);
    reflectance::Scheme unmixed = test::scheme_of(scheme);
    build(unmixed, made);
    return reflectance::pdf(unmixed, made, u, v);
  };
  EXPECT_EQ(pdf("hemisphere", "phong n=60"), pdf("hemisphere exp=60", "diffuse"));
  EXPECT_EQ(pdf("sphere", "blinn n=60"), pdf("sphere exp=15", "diffuse"));
  EXPECT_EQ(pdf("sphere", "diffuse"), pdf("sphere exp=10", "phong n=60"));
  EXPECT_EQ(pdf("anisotropic", "ashikhmin ex=10 ey=90"), pdf("anisotropic nu=10 nv=90", "diffuse"));
  EXPECT_EQ(pdf("anisotropic nv=7", "ashikhmin ex=10 ey=90"), pdf("anisotropic nu=10 nv=7", "diffuse"));
}

float cosine_fraction(const std::string& brdf, const std::string& scheme) {
  return Reflector(test::brdf_of(brdf), test::scheme_of(scheme)).cosine_fraction();
}

TEST(CosineShare, IsOfALobeThatMissesPart) {
  // Towards grazing, a lobe about h is far narrower across the plane of u and the normal than one about r,
  // and the wide lobe about r ends a right angle from it.
  EXPECT_GE(cosine_fraction("phong n=20 ks=0.5 kd=0", "anisotropic"), 0.1F);
  EXPECT_GE(cosine_fraction("diffuse", "hemisphere exp=0"), 0.1F);
  for (const std::string scheme : {"hemisphere exp=100", "sphere exp=100", "anisotropic nu=400"}) {
    for (const std::string brdf : {"diffuse kd=1", "phong n=100 ks=0.4 kd=0.6", "oren s=0.3",
                                   "lafortune n=50 kp=0 Cx=1 Cy=1 Cz=1", "blinn n=3 ks=1 kd=0"}) {
      EXPECT_GE(cosine_fraction(brdf, scheme), 0.1F) << scheme << brdf;
    }
  }
}

TEST(CosineShare, IsNoneWhereALobeCoversTheBrdf) {
  EXPECT_EQ(cosine_fraction("lewis n=100 ks=1 kd=0", "hemisphere"), 0);
  EXPECT_EQ(cosine_fraction("lewis n=100 ks=1 kd=0", "sphere"), 0);
  EXPECT_EQ(cosine_fraction("lewis n=100 ks=1 kd=0", "hemisphere exp=60"), 0);
  EXPECT_EQ(cosine_fraction("blinn n=20 ks=0.5 kd=0", "anisotropic"), 0);
  EXPECT_EQ(cosine_fraction("ashikhmin ex=10 ey=100 Rs=0.5 Rd=0", "anisotropic"), 0);
  EXPECT_EQ(cosine_fraction("lewis n=0 ks=1 kd=0", "hemisphere"), 0);
  EXPECT_EQ(cosine_fraction("diffuse kd=0", "hemisphere exp=100"), 0);
  EXPECT_EQ(cosine_fraction("specular", "hemisphere exp=100"), 0);
}

TEST(LobeSchemes, AreDefinedAtTheirEnds) {
  for (const std::string scheme : {"hemisphere exp=0", "hemisphere exp=1000000", "sphere exp=1000000",
                                   "anisotropic nu=0 nv=1000000", "anisotropic nu=1000000 nv=0"}) {
    const Reflector subject(test::brdf_of("ward"), test::scheme_of(scheme));
    for (const test::Pair& pair : test::direction_pairs(4000, 21)) {
      const float pdf = subject.pdf(pair.u, pair.v);
      ASSERT_TRUE(std::isfinite(pdf) && pdf >= 0) << scheme << pair.u << pair.v;
      const auto sample =
          subject.sample(pair.u, {{std::abs(pair.v.x), std::abs(pair.v.y)}, std::abs(pair.v.z) * 0.99F});
      if (!sample) continue;
      for (int k = 0; k < 3; ++k)
        ASSERT_TRUE(std::isfinite(sample->weight[k]) && sample->weight[k] >= 0) << scheme << pair.u;
    }
  }
}

}  // namespace
