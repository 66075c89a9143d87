#include "renderer/transport/sobol.h"

#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace {

using transport::sobol_point;
using transport::Uniform4;

std::array<float, 4> as_array(const Uniform4& p) { return {p.x, p.y, p.z, p.w}; }

// Owen scrambling preserves nets: of 2^k points, each elementary interval of area 2^-k has exactly one.
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
    transport::PathSampler one_by_one(sample * 31, sample);
    transport::PathSampler together(sample * 31, sample);
    const Uniform4 first = one_by_one.next();
    const Uniform4 second = one_by_one.next();
    const auto two = together.next_two();
    EXPECT_EQ(as_array(two.first), as_array(first));
    EXPECT_EQ(as_array(two.second), as_array(second));
  }
}

// Independent samples: each number is uniform, and no two of a path or of consecutive paths are correlated.
TEST(IndependentPoints, AreUniformAndUncorrelated) {
  constexpr std::size_t Numbers = 12;
  constexpr std::uint32_t Samples = 40000;
  std::array<std::array<double, Numbers>, Numbers> products = {};
  std::array<double, Numbers> sums = {};
  std::array<double, Numbers> before = {};
  std::array<double, Numbers> with_before = {};
  for (std::uint32_t sample = 0; sample < Samples; ++sample) {
    transport::PathSampler sampler(7, sample, transport::SamplePattern::Independent);
    const auto two = sampler.next_two();
    const auto set = sampler.next_set(100);
    std::array<double, Numbers> all;
    std::size_t at = 0;
    for (const Uniform4& p : {two.first, two.second, set[99]}) {
      for (const float x : as_array(p)) all[at++] = x - 0.5;
    }
    for (std::size_t i = 0; i < Numbers; ++i) {
      sums[i] += all[i];
      with_before[i] += all[i] * before[i];
      for (std::size_t k = 0; k < i; ++k) products[i][k] += all[i] * all[k];
    }
    before = all;
  }
  const double bound = 4.5 * (1.0 / 12) * std::sqrt(Samples);  // of 90 sums, 4.5 deviations each
  for (std::size_t i = 0; i < Numbers; ++i) {
    EXPECT_NEAR(sums[i], 0, 4.5 * std::sqrt(Samples / 12.0));
    EXPECT_NEAR(with_before[i], 0, bound);
    for (std::size_t k = 0; k < i; ++k) EXPECT_NEAR(products[i][k], 0, bound) << i << " " << k;
  }
}

// As many cells are empty as expected by chance, where a net has one point in each.
TEST(IndependentPoints, AreNoNet) {
  constexpr std::uint32_t Samples = 1024;
  std::set<int> of_samples;
  std::set<int> of_a_set;
  const auto set = transport::PathSampler(3, 0, transport::SamplePattern::Independent).next_set(Samples);
  for (std::uint32_t i = 0; i < Samples; ++i) {
    of_samples.insert(static_cast<int>(
        transport::PathSampler(3, i, transport::SamplePattern::Independent).next().x * Samples));
    of_a_set.insert(static_cast<int>(set[static_cast<int>(i)].x * Samples));
  }
  const double expected = Samples * (1 - std::exp(-1));
  EXPECT_NEAR(static_cast<double>(of_samples.size()), expected, 50);
  EXPECT_NEAR(static_cast<double>(of_a_set.size()), expected, 50);
}

// Split paths are as well distributed as more samples would be, and reuse no random numbers.
TEST(Sobol, BranchesOfAllSamplesAreANet) {
  constexpr int Branches = 2;
  std::set<std::pair<int, int>> cells;
  for (std::uint32_t sample = 0; sample < 32; ++sample) {
    transport::PathSampler sampler(17, sample);
    const Uniform4 before = sampler.next();
    for (int i = 0; i < Branches; ++i) {
      const Uniform4 p = sampler.branch(i, Branches).next();
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
