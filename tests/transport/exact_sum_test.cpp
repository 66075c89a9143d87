#include "renderer/transport/exact_sum.h"

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "renderer/transport/film.h"

namespace {

using boost::multiprecision::cpp_int;
using transport::ExactRgbSum;
using transport::ExactSum;
using transport::Rgb;

/// Floats of all magnitudes below the limit, of both signs.
std::vector<float> random_terms(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<float> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-36, 39);
  std::vector<float> terms;
  while (terms.size() < count) terms.push_back(std::ldexp(mantissa(random), exponent(random)));
  return terms;
}

// The expected sum is of integers of any length: a float of at least 2^-60 and 24 bits is a multiple of
// 2^-84.
TEST(ExactSum, IsThatOfIntegersOfAnyLength) {
  std::mt19937 random(1);
  const std::vector<float> terms = random_terms(random, 100'000);
  ExactSum sum;
  cpp_int expected = 0;
  for (const float term : terms) {
    // Multiples of the sum's steps are not rounded.
    const float multiple = std::ldexp(std::nearbyint(std::ldexp(term, 37)), -37);
    sum.add(multiple);
    int exponent = 0;
    const auto digits = static_cast<long long>(std::ldexp(std::frexp(multiple, &exponent), 24));
    const int shift = exponent - 24 + 84;
    expected += shift >= 0 ? cpp_int(digits) << shift : cpp_int(digits >> -shift);
  }
  EXPECT_EQ(sum.value(), expected.convert_to<double>() * 0x1p-84);
}

RC_GTEST_PROP(ExactSum, DoesNotDependOnOrderOrGrouping, (std::uint32_t seed)) {
  std::mt19937 random(seed);
  std::vector<float> terms = random_terms(random, 50);
  ExactSum in_order;
  for (const float term : terms) in_order.add(term);
  std::shuffle(terms.begin(), terms.end(), random);
  ExactSum all;
  for (std::size_t i = 0; i < terms.size();) {
    ExactSum group;
    const std::size_t end = i + 1 + random() % 10;
    for (; i < std::min(end, terms.size()); ++i) group.add(terms[i]);
    all += group;
  }
  RC_ASSERT(all == in_order);
  all -= in_order;
  RC_ASSERT(all.value() == 0);
}

// The float 0.1 is 13421773 / 2^27.
TEST(ExactSum, LosesNothingOverMillionsOfTerms) {
  ExactSum sum;
  for (int i = 0; i < 4'000'000; ++i) sum.add(0.1F);
  EXPECT_EQ(sum.value(), 4e6 * 13421773 / 134217728);
  const float largest = std::nextafter(ExactSum::Limit, 0.0F);
  for (int i = 0; i < 1000; ++i) sum.add(largest);
  for (int i = 0; i < 1000; ++i) sum.add(-largest);
  EXPECT_EQ(sum.value(), 4e6 * 13421773 / 134217728);
}

// Steps are 2^-60.
TEST(ExactSum, RoundsTheSmallestTerms) {
  ExactSum sum;
  sum.add(0x1.8p-60F);  // to the even neighbour
  EXPECT_EQ(sum.value(), 0x1p-59);
  sum.add(0x1p-62F);
  EXPECT_EQ(sum.value(), 0x1p-59);
  sum.add(-0x1p-59F);
  EXPECT_EQ(sum.value(), 0);
}

TEST(ExactRgbSum, RefusesWhatItCannotAdd) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad :
       {infinity, -infinity, std::numeric_limits<float>::quiet_NaN(), ExactSum::Limit, 1e38F}) {
    for (int channel = 0; channel < 3; ++channel) {
      Rgb term(1);
      term[channel] = bad;
      EXPECT_FALSE(ExactRgbSum::can_add(term)) << bad;
    }
  }
  EXPECT_TRUE(ExactRgbSum::can_add(Rgb(0, -1, 1e12F)));
  transport::FilmTile tile{{0, 0, 1, 1}, {}, std::vector<transport::FilmTile::PixelSums>(1), {}};
  EXPECT_FALSE(tile.add(0, 0, 0, Rgb(1, 2e12F, 1)));
  EXPECT_TRUE(tile.add(0, 0, 0, Rgb(1, 2, 3)));
  tile.counts = {2, 0};
  EXPECT_EQ(tile.mean(0), Rgb(0.5F, 1, 1.5F)) << "the first sample counts as black";
}

}  // namespace
