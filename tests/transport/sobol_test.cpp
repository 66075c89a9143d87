#include "renderer/transport/sobol.h"

#include <array>
#include <set>

#include <gtest/gtest.h>

namespace {

using transport::sobol_point;
using transport::Uniform4;

std::array<float, 4> as_array(const Uniform4& p) { return {p.x, p.y, p.z, p.w}; }

// Owen scrambling keeps a net: of 2^k points, each elementary interval of area 2^-k holds exactly one.
TEST(Sobol, FirstTwoDimensionsAreNets) {
  for (const std::uint32_t seed : {0U, 1U, 12345U}) {
    for (int k = 1; k <= 10; ++k) {
      for (int a = 0; a <= k; ++a) {
        std::set<std::pair<int, int>> cells;
        for (std::uint32_t i = 0; i < (1U << k); ++i) {
          const Uniform4 p = sobol_point(i, seed);
          cells.emplace(static_cast<int>(p.x * static_cast<float>(1 << a)),
                        static_cast<int>(p.y * static_cast<float>(1 << (k - a))));
        }
        ASSERT_EQ(cells.size(), 1U << k) << "seed " << seed << " k " << k << " a " << a;
      }
    }
  }
}

TEST(Sobol, EachDimensionIsStratified) {
  for (const std::uint32_t seed : {0U, 99U}) {
    for (std::size_t dimension = 0; dimension < 4; ++dimension) {
      std::set<int> cells;
      for (std::uint32_t i = 0; i < 4096; ++i) {
        cells.insert(static_cast<int>(as_array(sobol_point(i, seed))[dimension] * 4096));
      }
      EXPECT_EQ(cells.size(), 4096U);
    }
  }
}

TEST(Sobol, TwoPointsAreThoseOfTwoCalls) {
  for (std::uint32_t sample = 0; sample < 1000; ++sample) {
    transport::PathNumbers one_by_one(sample * 31, sample);
    transport::PathNumbers together(sample * 31, sample);
    const Uniform4 first = one_by_one.next();
    const Uniform4 second = one_by_one.next();
    const auto two = together.next_two();
    EXPECT_EQ(as_array(two.first), as_array(first));
    EXPECT_EQ(as_array(two.second), as_array(second));
  }
}

// What splits goes on with as good a spread as more samples would have, in numbers that nothing before has.
TEST(Sobol, BranchesOfAllSamplesAreANet) {
  constexpr int Branches = 2;
  std::set<std::pair<int, int>> cells;
  for (std::uint32_t sample = 0; sample < 32; ++sample) {
    transport::PathNumbers numbers(17, sample);
    const Uniform4 before = numbers.next();
    for (int i = 0; i < Branches; ++i) {
      const Uniform4 p = numbers.branch(i, Branches).next();
      EXPECT_NE(as_array(p), as_array(before));
      cells.emplace(static_cast<int>(p.x * 8), static_cast<int>(p.y * 8));
    }
  }
  EXPECT_EQ(cells.size(), 64U);
}

TEST(Sobol, StaysUnderOne) {
  for (std::uint32_t i = 0; i < 100000; ++i) {
    for (const float x : as_array(sobol_point(i, i * 7919))) {
      ASSERT_GE(x, 0);
      ASSERT_LT(x, 1);
    }
  }
}

// Sequences of different seeds must be independent: the same point of many is uniform and uncorrelated.
TEST(Sobol, SeedsAreIndependent) {
  double sum = 0;
  double product = 0;
  constexpr int Seeds = 100000;
  for (std::uint32_t seed = 0; seed < Seeds; ++seed) {
    const double a = sobol_point(5, seed).x - 0.5;
    const double b = sobol_point(5, seed + 1).x - 0.5;
    sum += a;
    product += a * b;
  }
  EXPECT_NEAR(sum / Seeds, 0, 4 * std::sqrt(1.0 / 12 / Seeds));
  EXPECT_NEAR(product / Seeds, 0, 4 * (1.0 / 12) / std::sqrt(Seeds));
}

}  // namespace
