// Properties of every formula, over a million random and hard triples of u, v and parameters per model.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/random_models.h"

namespace {

using reflectance::Rgb;
using reflectance::Vec3f;
using test::Failures;
using test::for_each_set;
using test::Pair;
using test::PairsPerSet;
using Vec3d = Imath::V3d;

/// Below it, floats lose digits.
constexpr double LeastFloat = std::numeric_limits<float>::min();

template <class Model>
Vec3d exact(const Model& model, const Vec3f& u, const Vec3f& v) {
  return model.evaluate(Vec3d(u), Vec3d(v));
}

template <class Model>
class RandomParameters : public testing::Test {};

TYPED_TEST_SUITE(RandomParameters, test::TypesOf<reflectance::FormulaBrdf>::Types, test::KeywordOf);

TYPED_TEST(RandomParameters, AreFiniteNotNegativeAndZeroUnderTheHorizon) {
  Failures failures;
  for_each_set<TypeParam>([&](const TypeParam& model, std::span<const Pair> pairs) {
    for (const Pair& pair : pairs) {
      const bool is_above = pair.u.z > 1e-12F && pair.v.z > 1e-12F;
      const Rgb f = model.evaluate(pair.u, pair.v);
      for (int k = 0; k < 3; ++k) {
        const bool is_right = std::isfinite(f[k]) && f[k] >= 0 && (is_above || f[k] == 0);
        if (!is_right) failures.add(1, model, pair, f[k], 0);
      }
    }
  });
  failures.expect_none();
}

// Models with an exception in their table are skipped.
TYPED_TEST(RandomParameters, AreReciprocalWhereTheTableSaysSo) {
  Failures failures;
  for_each_set<TypeParam>([&](const TypeParam& model, std::span<const Pair> pairs) {
    for (const Pair& pair : pairs) {
      const Rgb forth = model.evaluate(pair.u, pair.v);
      const Rgb back = model.evaluate(pair.v, pair.u);
      for (int k = 0; k < 3; ++k) {
        const double difference = std::abs(forth[k] - back[k]);
        const double larger = std::max(forth[k], back[k]);
        if (difference > 1e-4 * larger) failures.add(difference / larger, model, pair, forth[k], back[k]);
      }
    }
  });
  if (TypeParam::table().not_reciprocal.empty()) {
    failures.expect_none();
  } else {
    EXPECT_FALSE(failures.are_none());
  }
}

TYPED_TEST(RandomParameters, AreInFloatWhatTheyAreInDouble) {
  Failures failures;
  std::vector<Vec3d> values(PairsPerSet);
  for_each_set<TypeParam>([&](const TypeParam& model, std::span<const Pair> pairs) {
    Vec3d peak(0);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      values[i] = exact(model, pairs[i].u, pairs[i].v);
      for (int k = 0; k < 3; ++k) peak[k] = std::max(peak[k], values[i][k]);
    }
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Rgb f = model.evaluate(pairs[i].u, pairs[i].v);
      for (int k = 0; k < 3; ++k) {
        const double expected = values[i][k];
        const double difference = std::abs(f[k] - expected);
        if (expected < std::max(1e-6 * peak[k], LeastFloat) || difference <= 1e-3 * expected) continue;
        if (is_taken_nearby(model, pairs[i], k, f[k])) continue;
        failures.add(difference / expected, model, pairs[i], f[k], expected);
      }
    }
  });
  failures.expect_none();
}

}  // namespace
