// What every formula promises, over random and hard directions and parameters.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/reflectance/brdf_cases.h"

namespace {

using reflectance::Brdf;
using reflectance::Rgb;
using reflectance::Vec3f;
using test::Pair;

constexpr int PairCount = 20000;

std::vector<std::string> all_cases() {
  std::vector<std::string> cases = test::extreme_cases();
  cases.insert(cases.end(), test::plain_cases().begin(), test::plain_cases().end());
  cases.insert(cases.end(), {"phong n=100000", "blinn n=100000", "lewis n=100000", "ward sx=0.001 sy=1"});
  return cases;
}

Imath::V3d evaluate_in_double(const Brdf& brdf, const Vec3f& u, const Vec3f& v) {
  return std::visit([&](const auto& model) { return model.evaluate(Imath::V3d(u), Imath::V3d(v)); }, brdf);
}

class Formula : public testing::TestWithParam<std::string> {};

TEST_P(Formula, IsFiniteNotNegativeAndZeroUnderTheHorizon) {
  const Brdf brdf = test::brdf_of(GetParam());
  for (const Pair& pair : test::direction_pairs(PairCount, 1)) {
    const Rgb f = evaluate(brdf, pair.u, pair.v);
    for (const float channel : {f.x, f.y, f.z}) {
      ASSERT_TRUE(std::isfinite(channel) && channel >= 0) << pair.u << pair.v << f;
      const bool is_above = pair.u.z > 0 && pair.v.z > 0;
      ASSERT_TRUE(is_above || channel == 0) << pair.u << pair.v << f;
    }
  }
}

TEST_P(Formula, IsReciprocal) {
  const Brdf brdf = test::brdf_of(GetParam());
  for (const Pair& pair : test::direction_pairs(PairCount, 2)) {
    const float forth = evaluate(brdf, pair.u, pair.v).x;
    const float back = evaluate(brdf, pair.v, pair.u).x;
    ASSERT_NEAR(forth, back, 1e-4F * std::max(forth, back)) << pair.u << pair.v;
  }
}

TEST_P(Formula, IsInFloatWhatItIsInDouble) {
  const Brdf brdf = test::brdf_of(GetParam());
  const std::vector<Pair> pairs = test::direction_pairs(PairCount, 3);
  double peak = 0;
  for (const Pair& pair : pairs) peak = std::max(peak, evaluate_in_double(brdf, pair.u, pair.v).x);
  for (const Pair& pair : pairs) {
    const double exact = evaluate_in_double(brdf, pair.u, pair.v).x;
    if (exact < 1e-6 * peak) continue;
    ASSERT_NEAR(evaluate(brdf, pair.u, pair.v).x, exact, 1e-3 * exact) << pair.u << pair.v;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Formula, testing::ValuesIn(all_cases()), [](const auto& instance) {
  std::string name = instance.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name + "_" + std::to_string(instance.index);
});

TEST(Identity, NarrowLobesHaveTheirPeaks) {
  const Vec3f u = test::direction(30, 20);
  const Vec3f v = reflectance::mirrored(u);
  EXPECT_FLOAT_EQ(evaluate(test::brdf_of("phong n=1000000 ks=1 kd=0"), u, v).x, 1);
  EXPECT_FLOAT_EQ(evaluate(test::brdf_of("blinn n=1000000 ks=1 kd=0"), u, v).x, 1);
  EXPECT_NEAR(evaluate(test::brdf_of("lewis n=98 ks=1 kd=0"), u, v).x, 100 / (2 * M_PI), 1e-4);
}

TEST(Identity, WardIsItsClosedForm) {
  const Vec3f u = test::direction(40, 10);
  const Vec3f v = test::direction(25, 170);
  const Vec3f h = (u + v).normalized();
  const double exponent = (h.x / 0.2) * (h.x / 0.2) + (h.y / 0.1) * (h.y / 0.1);
  const double expected = 0.3 / M_PI + 0.4 * std::exp(-exponent / (h.z * h.z)) /
                                           (4 * M_PI * 0.2 * 0.1 * std::sqrt(double(u.z) * double(v.z)));
  EXPECT_NEAR(evaluate(test::brdf_of("ward sx=0.2 sy=0.1 ks=0.4 kd=0.3"), u, v).x, expected, 1e-5 * expected);
}

TEST(Identity, WardTakesTheSlopeAlongXForTheOtherOne) {
  const Vec3f u = test::direction(40, 10);
  const Vec3f v = test::direction(25, 200);
  EXPECT_EQ(evaluate(test::brdf_of("ward sx=0.3"), u, v),
            evaluate(test::brdf_of("ward sx=0.3 sy=0.3"), u, v));
}

TEST(Log1p, IsWithinTwoUnitsInTheLastPlace) {
  for (const Pair& pair : test::direction_pairs(20000, 4)) {
    for (const float x : {pair.u.x * 0.999F, pair.u.z * 1e-4F, std::exp2(100 * pair.v.x)}) {
      const float y = reflectance::glsl::log1p(x);
      const double exact = std::log1p(static_cast<double>(x));
      ASSERT_NEAR(y, exact, 2.5 * std::abs(exact) * 0x1p-23) << x;
    }
  }
}

}  // namespace
