// Properties of every formula, over random and hard directions and parameters.
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
  cases.insert(cases.end(), test::stepped_cases().begin(), test::stepped_cases().end());
  cases.insert(cases.end(), test::hard_cases().begin(), test::hard_cases().end());
  return cases;
}

Imath::V3d evaluate_in_double(const Brdf& brdf, const Imath::V3d& u, const Imath::V3d& v) {
  return std::visit([&](const auto& model) { return model.evaluate(u, v); }, brdf);
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

/// The cases without an exception in their table; promises_test covers the others.
class ReciprocalFormula : public Formula {};

TEST_P(ReciprocalFormula, IsTheSameBothWays) {
  const Brdf brdf = test::brdf_of(GetParam());
  for (const Pair& pair : test::direction_pairs(PairCount, 2)) {
    const float forth = evaluate(brdf, pair.u, pair.v).x;
    const float back = evaluate(brdf, pair.v, pair.u).x;
    ASSERT_NEAR(forth, back, 1e-4F * std::max(forth, back)) << pair.u << pair.v;
  }
}

/// The isotropic cases.
class IsotropicFormula : public Formula {};

TEST_P(IsotropicFormula, StaysTheSameWhenTurned) {
  const Brdf brdf = test::brdf_of(GetParam());
  const double sine = std::sin(0.7);
  const double cosine = std::cos(0.7);
  const auto turned = [&](const Vec3f& w) {
    return Imath::V3d(cosine * w.x - sine * w.y, sine * w.x + cosine * w.y, w.z);
  };
  for (const Pair& pair : test::direction_pairs(PairCount, 4)) {
    const double before = evaluate_in_double(brdf, Imath::V3d(pair.u), Imath::V3d(pair.v)).x;
    const double after = evaluate_in_double(brdf, turned(pair.u), turned(pair.v)).x;
    ASSERT_NEAR(before, after, 3e-6 * before + 1e-12) << pair.u << pair.v;
  }
}

TEST_P(Formula, IsInFloatWhatItIsInDouble) {
  const Brdf brdf = test::brdf_of(GetParam());
  const std::vector<Pair> pairs = test::direction_pairs(PairCount, 3);
  double peak = 0;
  for (const Pair& pair : pairs)
    peak = std::max(peak, evaluate_in_double(brdf, Imath::V3d(pair.u), Imath::V3d(pair.v)).x);
  for (const Pair& pair : pairs) {
    const double exact = evaluate_in_double(brdf, Imath::V3d(pair.u), Imath::V3d(pair.v)).x;
    if (exact < 1e-6 * peak) continue;
    ASSERT_NEAR(evaluate(brdf, pair.u, pair.v).x, exact, 1e-3 * exact) << pair.u << pair.v;
  }
}

std::string name_of_case(const testing::TestParamInfo<std::string>& instance) {
  std::string name = instance.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name + "_" + std::to_string(instance.index);
}

std::vector<std::string> cases_that(bool (*is_wanted)(const Brdf&)) {
  std::vector<std::string> cases = all_cases();
  std::erase_if(cases, [&](const std::string& text) {
    // A table takes long to make, and its model makes none of the exceptions.
    return !text.starts_with("table") && !is_wanted(test::brdf_of(text));
  });
  return cases;
}

bool is_reciprocal(const Brdf& brdf) {
  if (const auto* sum = std::get_if<reflectance::Combine>(&brdf)) {
    return std::all_of(sum->parts->begin(), sum->parts->end(),
                       [](const auto& part) { return is_reciprocal(part.brdf); });
  }
  return test::info_of(brdf).not_reciprocal.empty();
}

INSTANTIATE_TEST_SUITE_P(Cases, Formula, testing::ValuesIn(all_cases()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Cases, ReciprocalFormula, testing::ValuesIn(cases_that(is_reciprocal)),
                         name_of_case);
INSTANTIATE_TEST_SUITE_P(Cases, IsotropicFormula, testing::ValuesIn(cases_that([](const Brdf& brdf) {
                           return !is_anisotropic(brdf);
                         })),
                         name_of_case);

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

TEST(Log, IsWithinTwoUnitsInTheLastPlace) {
  for (const Pair& pair : test::direction_pairs(20000, 5)) {
    for (const float x : {std::abs(pair.u.z), 1 + 1e-4F * pair.u.x, std::exp2(100 * pair.v.x)}) {
      const double exact = std::log(static_cast<double>(x));
      ASSERT_NEAR(reflectance::glsl::log(x), exact, 2.5 * std::abs(exact) * 0x1p-23) << x;
    }
  }
}

TEST(Atan2, KeepsItsDigitsInAllQuadrants) {
  for (const Pair& pair : test::direction_pairs(20000, 6)) {
    for (const float x : {pair.v.z, std::exp2(30 * pair.v.x)}) {
      const float y = pair.u.x;
      const double exact = std::atan2(static_cast<double>(y), static_cast<double>(x));
      ASSERT_NEAR(reflectance::glsl::atan2(y, x), exact, 3e-7 * std::abs(exact)) << y << " " << x;
    }
  }
  EXPECT_EQ(reflectance::glsl::atan2(0.0F, 1.0F), 0);
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
