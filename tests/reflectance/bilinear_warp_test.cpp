// Interpolation and warps on the unit square: evaluation, sampling, and its inverse.
#include "renderer/reflectance/bilinear_warp.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "renderer/reflectance/observer.h"
#include "tests/statistics/chi_square.h"

namespace {

using grf::Vec2d;
using reflectance::BilinearTable;
using reflectance::BilinearWarp;
using reflectance::NodeGrid;
using reflectance::SliceGrid;
using reflectance::SliceWeights;
using reflectance::WarpedPoint;

class Uniform {
 public:
  double next() { return distribution_(random_); }
  Vec2d point() {
    const double x = next();
    return {x, next()};
  }

 private:
  std::mt19937 random_{3};
  std::uniform_real_distribution<double> distribution_{0, 1};
};

/// Makes densities over several orders of magnitude, with cells and whole rows of zeros.
std::vector<float> rough_values(const NodeGrid& grid, std::size_t slices) {
  Uniform uniform;
  std::vector<float> values;
  for (std::size_t i = 0; i < slices * grid.node_count(); ++i) {
    const std::size_t row = i / grid.width % grid.height;
    const bool is_zero = uniform.next() < 0.2 || row == 2 || row == 3;
    values.push_back(is_zero ? 0 : static_cast<float>(std::pow(10, 4 * uniform.next())));
  }
  return values;
}

TEST(SliceGrid, InterpolatesBothParameters) {
  const SliceGrid grid({-1, 0, 3}, {0, 0.5F, 2});
  const std::vector<double> values = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  const auto at = [&](double outer, double inner) {
    return grid.around(outer, inner).interpolate([&](std::size_t slice) { return values[slice]; });
  };
  EXPECT_EQ(grid.slice_count(), 9U);
  EXPECT_DOUBLE_EQ(at(-1, 0), 1);
  EXPECT_DOUBLE_EQ(at(3, 2), 9);
  EXPECT_DOUBLE_EQ(at(0, 0.5), 5);
  EXPECT_DOUBLE_EQ(at(1.5, 1.25), (5 + 6 + 8 + 9) / 4.0);
  EXPECT_DOUBLE_EQ(at(-0.5, 0.1), 0.8 * (1 + 4) / 2 + 0.2 * (2 + 5) / 2);
  EXPECT_DOUBLE_EQ(at(-7, 9), 3) << "beyond the ends";
  EXPECT_DOUBLE_EQ(
      SliceGrid({0}, {0, 1}).around(5, 0.25).interpolate([](std::size_t i) { return double(i); }), 0.25);
}

TEST(BilinearTable, IsExactForBilinearFunctions) {
  const NodeGrid grid{5, 4};
  const auto function = [](double x, double y, double k) { return 2 + 3 * x - y + 4 * x * y + 10 * k; };
  std::vector<float> values;
  for (int channel = 0; channel < 2; ++channel) {
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 5; ++x) values.push_back(static_cast<float>(function(x / 4.0, y / 3.0, channel)));
    }
  }
  const BilinearTable table(grid, 2, values);
  Uniform uniform;
  for (int i = 0; i < 100; ++i) {
    const Vec2d p = uniform.point();
    EXPECT_NEAR(table.evaluate(p, {}, 0), function(p.x, p.y, 0), 1e-6);
    EXPECT_NEAR(table.evaluate(p, {}, 1), function(p.x, p.y, 1), 1e-6);
    EXPECT_NEAR(table.mixed({{0.25, 0.75}}).evaluate(p, {}), function(p.x, p.y, 0.75), 1e-5);
  }
  EXPECT_NEAR(table.evaluate({-3, 7}, {}, 0), function(0, 1, 0), 1e-6) << "clamped";
  EXPECT_NEAR(table.evaluate({1, 1}, {}, 0), function(1, 1, 0), 1e-6);
  EXPECT_EQ(BilinearTable({1, 2}, 1, {3, 5}).evaluate({0.9, 0.5}, {}), 4) << "one column";
}

class BilinearWarps : public testing::Test {
 protected:
  const NodeGrid grid_{9, 7};
  const SliceGrid parameters_{{0, 1}, {0, 1, 2}};
  const BilinearWarp warp_{grid_, rough_values(grid_, 6)};
  const std::vector<SliceWeights> weights_ = {parameters_.around(0, 0), parameters_.around(0.3, 1.6),
                                              parameters_.around(1, 0.5)};
};

TEST_F(BilinearWarps, AreInverted) {
  Uniform uniform;
  for (const SliceWeights& slices : weights_) {
    for (int i = 0; i < 3000; ++i) {
      const Vec2d xi = uniform.point();
      const WarpedPoint sampled = warp_.sample(xi, slices);
      const WarpedPoint inverse = warp_.invert(sampled.point, slices);
      ASSERT_NEAR(inverse.point.x, xi.x, 1e-7);
      ASSERT_NEAR(inverse.point.y, xi.y, 1e-7);
      ASSERT_NEAR(inverse.pdf, sampled.pdf, 1e-6 * sampled.pdf);
      ASSERT_NEAR(warp_.pdf(sampled.point, slices), sampled.pdf, 1e-6 * sampled.pdf);
    }
  }
}

TEST_F(BilinearWarps, HaveTheDensityOfTheNodesAndTheIntegralOne) {
  const NodeGrid grid{3, 2};
  const BilinearWarp warp(grid, {0, 1, 2, 4, 6, 2});
  // The mean of the cells' means: (0+1+4+6)/4 and (1+2+6+2)/4.
  const double integral = ((0 + 1 + 4 + 6) / 4.0 + (1 + 2 + 6 + 2) / 4.0) / 2;
  EXPECT_NEAR(warp.pdf({0, 1}, {}), 4 / integral, 1e-12);
  EXPECT_NEAR(warp.pdf({0.25, 0.5}, {}), (0 + 1 + 4 + 6) / 4.0 / integral, 1e-12);
  for (const SliceWeights& slices : weights_) {
    double sum = 0;
    constexpr int Count = 480;  // a multiple of the cells in both directions: the midpoint rule is exact
    for (int y = 0; y < Count; ++y) {
      for (int x = 0; x < Count; ++x) sum += warp_.pdf({(x + 0.5) / Count, (y + 0.5) / Count}, slices);
    }
    EXPECT_NEAR(sum / (Count * Count), 1, 1e-9);
  }
}

TEST_F(BilinearWarps, SampleTheirDensity) {
  constexpr int Cells = 12;
  constexpr int Fine = 24;
  constexpr int Samples = 100000;
  Uniform uniform;
  for (const SliceWeights& slices : weights_) {
    std::vector<double> expected(Cells * Cells, 0.0);
    std::vector<double> counts(Cells * Cells, 0.0);
    for (int y = 0; y < Cells * Fine; ++y) {
      for (int x = 0; x < Cells * Fine; ++x) {
        const Vec2d p((x + 0.5) / (Cells * Fine), (y + 0.5) / (Cells * Fine));
        expected[static_cast<std::size_t>(x / Fine + Cells * (y / Fine))] +=
            warp_.pdf(p, slices) * Samples / (Cells * Fine * Cells * Fine);
      }
    }
    for (int i = 0; i < Samples; ++i) {
      const Vec2d p = warp_.sample(uniform.point(), slices).point;
      counts[static_cast<std::size_t>(std::min(p.x, 0.999) * Cells) +
             Cells * static_cast<std::size_t>(std::min(p.y, 0.999) * Cells)] += 1;
    }
    EXPECT_GT(statistics::chi_square_p_value(expected, counts), statistics::significance(3));
  }
}

// Interpolating densities is right only if their cumulative distributions are interpolated likewise.
TEST_F(BilinearWarps, InterpolateDensitiesOfNormalisedSlices) {
  const SliceWeights between = parameters_.around(0.3, 1.6);
  Uniform uniform;
  for (int i = 0; i < 100; ++i) {
    const Vec2d p = uniform.point();
    const double expected =
        0.7 * (0.4 * warp_.pdf(p, parameters_.around(0, 1)) + 0.6 * warp_.pdf(p, parameters_.around(0, 2))) +
        0.3 * (0.4 * warp_.pdf(p, parameters_.around(1, 1)) + 0.6 * warp_.pdf(p, parameters_.around(1, 2)));
    EXPECT_NEAR(warp_.pdf(p, between), expected, 1e-6 * expected);
  }
}

TEST_F(BilinearWarps, TakeTheEndsOfTheSquare) {
  for (const SliceWeights& slices : weights_) {
    for (const Vec2d& corner : {Vec2d(0, 0), Vec2d(1, 0), Vec2d(0, 1), Vec2d(1, 1), Vec2d(-1, 2)}) {
      for (const WarpedPoint& point : {warp_.sample(corner, slices), warp_.invert(corner, slices)}) {
        EXPECT_TRUE(point.point.x >= 0 && point.point.x <= 1) << point.point;
        EXPECT_TRUE(point.point.y >= 0 && point.point.y <= 1) << point.point;
        EXPECT_TRUE(std::isfinite(point.pdf) && point.pdf >= 0);
      }
    }
  }
}

TEST(BilinearWarp, IsUniformWithoutDensity) {
  const BilinearWarp warp({4, 4}, std::vector<float>(16, 0.0F));
  const WarpedPoint point = warp.sample({0.3, 0.8}, {});
  EXPECT_NEAR(point.point.x, 0.3, 1e-12);
  EXPECT_NEAR(point.point.y, 0.8, 1e-12);
  EXPECT_NEAR(point.pdf, 1, 1e-12);
}

TEST(Observer, SeesGreyAsGrey) {
  for (const std::vector<float>& wavelengths :
       {std::vector<float>{550}, {400, 700}, {360, 400, 450, 500, 555, 600, 690, 830, 1000}}) {
    for (const std::vector<double>& row : reflectance::rgb_weights(wavelengths)) {
      double sum = 0;
      for (const double weight : row) sum += weight;
      EXPECT_NEAR(sum, 1, 1e-12);
    }
  }
}

TEST(Observer, SeesColours) {
  const auto red = reflectance::rgb_of_wavelength(630);
  EXPECT_GT(red.x, 3 * std::abs(red.y));
  const auto green = reflectance::rgb_of_wavelength(535);
  EXPECT_GT(green.y, 0.5);
  EXPECT_LT(green.x, 0.1);
  const auto blue = reflectance::rgb_of_wavelength(450);
  EXPECT_GT(blue.z, 1);
  EXPECT_NEAR(reflectance::rgb_of_wavelength(1000).length(), 0, 1e-6);
}

}  // namespace
