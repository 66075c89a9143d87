#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/reflectance/schemes/warp_trees.h"
#include "tests/reflectance/brdf_cases.h"

namespace test {

/// A generator of independent uniform numbers.
class Pairs {
 public:
  explicit Pairs(std::uint32_t seed) : random_(seed) {}
  float next() { return static_cast<float>(random_() >> 8U) * 0x1p-24F; }
  reflectance::Vec2f next_pair() {
    const float x = next();
    return {x, next()};
  }

 private:
  std::mt19937 random_;
};

/// Weights f cos / pdf in albedos, for random views up to 80 degrees.
struct Weights {
  double over_one_and_a_half = 0;  ///< fraction
  double largest = 0;
  bool are_valid = true;
};

inline Weights weights_of(const reflectance::Brdf& brdf, int views, int samples, std::uint32_t seed) {
  const reflectance::WarpTrees trees(brdf, reflectance::WarpTreesSettings());
  Pairs random(seed);
  Weights result;
  std::vector<double> weights(static_cast<std::size_t>(samples));
  double large = 0;
  for (int k = 0; k < views; ++k) {
    const double theta = 80 * static_cast<double>(random.next());
    const Vec3f u = direction(theta, 360 * static_cast<double>(random.next()));
    double sum = 0;
    for (double& weight : weights) {
      const auto drawn = trees.sample(u, random.next_pair());
      weight = drawn ? double(reflectance::mean(evaluate(brdf, u, drawn->direction))) * drawn->direction.z /
                           drawn->pdf
                     : 0;
      result.are_valid = result.are_valid && std::isfinite(weight) && weight >= 0;
      sum += weight;
    }
    const double albedo = sum / samples;
    for (const double weight : weights) {
      result.largest = std::max(result.largest, weight / albedo);
      large += weight > 1.5 * albedo ? 1 : 0;
    }
  }
  result.over_one_and_a_half = large / views / samples;
  return result;
}

/// Expects for the BRDFs of the thesis' table 5.5: 99.9 % of the weights are within 1.5 albedos, none
/// above 4.
inline void expect_even_weights(int views, int samples) {
  for (const ThesisCase& one : thesis_cases()) {
    const Weights weights = weights_of(brdf_of(one.brdf), views, samples, 3);
    EXPECT_TRUE(weights.are_valid) << one.brdf;
    EXPECT_LT(weights.over_one_and_a_half, 1e-3) << one.brdf;
    EXPECT_LT(weights.largest, 4) << one.brdf;
  }
}

}  // namespace test
