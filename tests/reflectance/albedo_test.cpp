#include "tests/reflectance/albedo.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/halton.h"

namespace {

using reflectance::Reflector;
using reflectance::Rgb;
using test::brdf_of;
using test::direction;

Rgb sampled(const std::string& brdf, double theta, double phi = 25) {
  const Reflector reflector(brdf_of(brdf), reflectance::OwnScheme());
  return reflectance::albedo(reflector, direction(theta, phi));
}

TEST(EvenPoints, FillEveryBoxAlike) {
  constexpr int Count = 30000;
  std::array<int, 64> boxes = {};
  for (std::uint32_t i = 0; i < Count; ++i) {
    const reflectance::Uniforms point = reflectance::halton_point(i);
    std::size_t box = 0;
    for (const float x : {point.direction.x, point.direction.y, point.choice}) {
      ASSERT_TRUE(x >= 0 && x < 1);
      box = 4 * box + static_cast<std::size_t>(4 * x);
    }
    ++boxes[box];
  }
  for (const int count : boxes) EXPECT_NEAR(count, Count / 64.0, 12);
  const reflectance::Uniforms last = reflectance::halton_point(0xfffffffeU);
  EXPECT_TRUE(last.direction.x < 1 && last.direction.y < 1 && last.choice < 1);
}

TEST(Albedo, IsThatOfAQuadrature) {
  for (const char* brdf :
       {"oren s=0.4 r=0.9", "phong n=50 ks=0.8 kd=0.5", "ward sx=0.15 sy=0.4 ks=0.6 kd=0.3",
        "torrance rough=0.35 nreal=0.617 nimag=2.63 ks=0.7 kd=0.3", "schlick SC=0.7 Sr=0.31",
        "ashikhmin ex=10 ey=100 Rs=0.5 Rd=0.5", "beardmaxwell", "kajiya", "granier", "poulin"}) {
    for (const double theta : {0.0, 45.0, 80.0}) {
      const double expected = test::albedo(brdf_of(brdf), direction(theta, 25), 1e-6);
      EXPECT_NEAR(sampled(brdf, theta).x, expected, 0.002 * std::max(1.0, expected))
          << brdf << " at " << theta;
    }
  }
}

// Nearly all light of a lobe this narrow is in one direction.
TEST(Albedo, OfNarrowLobesIsRightToo) {
  for (const double theta : {0.0, 45.0, 80.0}) {
    const double cosine = direction(theta, 25).z;
    EXPECT_NEAR(sampled("lewis n=1000000 ks=1 kd=0", theta).x, cosine, 0.002);
    EXPECT_NEAR(sampled("neumann r=0.001 ks=0.7", theta).x, 0.7, 0.002);
    EXPECT_NEAR(sampled("torrance rough=0.0005 nreal=0.177 nimag=3.638 ks=1 kd=0", theta).x,
                sampled("coupled Rm=0 R0=0.949", theta).x, 0.02)
        << "a mirror of silver";
  }
  EXPECT_NEAR(sampled("ward sx=0.0005 sy=0.01 ks=0.3 kd=0.2", 0).x, 0.5, 0.002);
}

TEST(Albedo, HasTheMirrorPartInIt) {
  EXPECT_EQ(sampled("specular ks=(0.9, 0.5, 0)", 60), Rgb(0.9F, 0.5F, 0));
  EXPECT_NEAR(sampled("coupled Rm=1 R0=0.3", 70).y, 1, 0.002);
  EXPECT_NEAR(sampled("he sigma=0 ks=0.8 kd=0.1", 40).z, 0.9, 0.002);
}

TEST(Albedo, IsNothingUnderTheHorizon) {
  EXPECT_EQ(sampled("diffuse", 100), Rgb(0));
  EXPECT_EQ(sampled("specular", 100), Rgb(0));
}

TEST(LargestAlbedo, IsWhereAModelReflectsMost) {
  const auto minnaert = largest_albedo(brdf_of("minnaert k=0.8 kd=1"));
  EXPECT_EQ(minnaert.degrees, 85);
  EXPECT_NEAR(minnaert.albedo, 2 / 1.8 * std::pow(std::cos(85 * reflectance::Pi / 180), -0.2), 0.01);
  const auto lewis = largest_albedo(brdf_of("lewis n=100 ks=1 kd=0.5"));
  EXPECT_EQ(lewis.degrees, 0);
  EXPECT_NEAR(lewis.albedo, 1.5, 0.01);
  EXPECT_NEAR(largest_albedo(brdf_of("diffuse kd=(0.1, 0.2, 0.9)")).albedo, 0.9, 1e-4) << "of all channels";
  EXPECT_EQ(largest_albedo(brdf_of("specular ks=0")).albedo, 0);
}

TEST(LargestAlbedo, IsAtMostOneWhereNothingIsGained) {
  for (const char* brdf : {"lewis n=100 ks=1 kd=0", "coupled Rm=1 R0=0.05", "oren s=0 r=1", "neumann r=0.2",
                           "torrance rough=0.5 nreal=0.1 nimag=50 ks=1 kd=0", "ashikhmin Rs=0.39 Rd=1",
                           "he sigma=0.5 tau=3 lambda=800", "kajiya", "poulin ks=0.8 kd=0.2", "westin",
                           "diffuse kd=1", "ward sx=0.2 ks=0.5 kd=0.5", "strauss s=0.5 ks=1 kd=1"}) {
    EXPECT_LT(largest_albedo(brdf_of(brdf)).albedo, 1.01F) << brdf;
  }
}

TEST(LargestAlbedo, IsKnownToTheCatalogue) {
  for (const grf::ModelInfo& model : reflectance::brdf_infos()) {
    if (model.argument_kind != grf::ModelInfo::ArgumentKind::Parameters)
      continue;  // without data or terms it is black
    ASSERT_NE(model.largest_albedo, nullptr) << model.keyword;
    grf::Model defaults;
    defaults.keyword = model.keyword;
    EXPECT_GT(model.largest_albedo(defaults).albedo, 0) << model.keyword;
  }
}

}  // namespace
