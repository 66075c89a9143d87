#include "renderer/transport/lights/environment_map.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>

#include <boost/math/distributions/chi_squared.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/transport/sobol.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/environment_images.h"

namespace {

using grf::Vec2f;
using grf::Vec3f;
using image::Image;
using reflectance::Rgb;
using test::image_of;
using transport::EnvironmentMap;

/// A sky with a gradient, black ground, noise and a sun.
Image sky(int width, int height) {
  std::mt19937 random(5);
  return image_of(width, height, [&](int x, int y) {
    if (y > height * 2 / 3) return 0.0F;
    if (x == width / 3 && y == height / 4) return 2000.0F;
    return 1.0F + static_cast<float>(y) + static_cast<float>(random() % 100) / 100;
  });
}

std::vector<EnvironmentMap> hard_maps() {
  std::vector<EnvironmentMap> maps;
  maps.emplace_back(image_of(1, 1, [](int, int) { return 3.0F; }));
  maps.emplace_back(image_of(1, 7, [](int, int y) { return static_cast<float>(y % 3); }));
  maps.emplace_back(image_of(9, 1, [](int x, int) { return static_cast<float>(x); }));
  maps.emplace_back(image_of(64, 32, [](int x, int y) { return x == 40 && y == 7 ? 1e30F : 0.0F; }));
  maps.emplace_back(image_of(64, 32, [](int x, int y) { return x == 63 && y == 31 ? 1e-30F : 0.0F; }));
  maps.emplace_back(image_of(8, 4, [](int, int) { return std::numeric_limits<float>::max(); }));
  // 135 degrees are 24 of 64 columns, so that cells of the chi-square test are within a texel.
  maps.emplace_back(image_of(64, 32, [](int x, int y) { return x == 40 && y == 7 ? 1e30F : 0.0F; }), 135.0F);
  maps.emplace_back(sky(64, 32), 135.0F);
  maps.emplace_back(sky(64, 32), 135.0F, EnvironmentMap::Weights::Compensated);
  maps.emplace_back(image_of(8, 4, [](int, int) { return 3.0F; }), 0.0F,
                    EnvironmentMap::Weights::Compensated);
  maps.emplace_back(sky(64, 32));
  return maps;
}

TEST(EnvironmentMap, LooksWhereItSays) {
  Image image = image_of(4, 3, [](int x, int y) { return static_cast<float>(10 * y + x); });
  const EnvironmentMap map(image);
  const float tiny = 1e-3F;
  EXPECT_EQ(map.radiance({tiny, 0, -1}).x, 12);   // the centre, just right of it
  EXPECT_EQ(map.radiance({-tiny, 0, -1}).x, 11);  // and left
  EXPECT_EQ(map.radiance({1, 0, -tiny}).x, 12);   // +x is a quarter right of the centre
  EXPECT_EQ(map.radiance({1, 0, tiny}).x, 13);
  EXPECT_EQ(map.radiance({-1, 0, tiny}).x, 10);
  EXPECT_EQ(map.radiance({tiny, 1, -tiny}).x, 2);
  EXPECT_EQ(map.radiance({tiny, -1, -tiny}).x, 22);
  EXPECT_LT(map.radiance({0, 1, 0}).x, 4);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) {
      EXPECT_EQ(map.radiance(Vec3f(test::direction_at<double>(image, x + 0.5, y + 0.5))), image.at(x, y))
          << x << ", " << y;
    }
  }
}

// A quarter turn counter-clockwise, seen from above, brings what was ahead (-z) to the left (-x).
TEST(EnvironmentMap, IsRotatedAboutTheVerticalAxis) {
  const Image image = image_of(8, 3, [](int x, int y) { return static_cast<float>(10 * y + x); });
  const EnvironmentMap map(image, 90);
  const float tiny = 1e-3F;
  EXPECT_EQ(map.radiance({-1, 0, -tiny}).x, 14);  // the centre, just right of it
  EXPECT_EQ(map.radiance({-1, 0, tiny}).x, 13);
  EXPECT_EQ(map.radiance({tiny, 0, -1}).x, 16);
  // A turn by two columns is the image shifted by two columns.
  Image shifted = image;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 8; ++x) shifted.pixels[std::size_t(8 * y + x)] = image.at((x + 2) % 8, y);
  }
  for (const float degrees : {90.0F, -270.0F}) {
    const EnvironmentMap rotated(image, degrees);
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 8; ++x) {
        const Vec3f direction(test::direction_at<double>(image, x + 0.5, y + 0.5));
        EXPECT_EQ(rotated.radiance(direction), shifted.at(x, y)) << degrees << ": " << x << ", " << y;
      }
    }
  }
}

TEST(EnvironmentMap, DensityIntegratesToOne) {
  for (const EnvironmentMap& map : hard_maps()) {
    const Image& image = map.image();
    double sum = 0;
    for (int y = 0; y < image.height; ++y) {
      const double solid_angle = 2 * std::numbers::pi / image.width *
                                 (std::cos(std::numbers::pi * y / image.height) -
                                  std::cos(std::numbers::pi * (y + 1) / image.height));
      for (int x = 0; x < image.width; ++x) {
        sum += solid_angle * double(map.pdf(Vec3f(test::direction_at<double>(image, x + 0.5, y + 0.5))));
      }
    }
    EXPECT_NEAR(sum, 1, 1e-5) << image.width << " x " << image.height;
  }
}

// The upper half has luminance 3, the lower 1, so the mean is 2: weights of 3 - 4/3, and of a hundredth of 1.
TEST(EnvironmentMap, LeavesWhatIsBelowTheMeanToBrdfSampling) {
  const EnvironmentMap map(image_of(4, 2, [](int, int y) { return y == 0 ? 3.0F : 1.0F; }), 0,
                           EnvironmentMap::Weights::Compensated);
  const double total = 2 * std::numbers::pi * (5.0 / 3 + 0.01);
  EXPECT_NEAR(map.pdf(Vec3f(0.6F, 0.8F, 0)), 5.0 / 3 / total, 1e-6);
  EXPECT_NEAR(map.pdf(Vec3f(0.6F, -0.8F, 0)), 0.01 / total, 1e-8);
  EXPECT_NEAR(map.total(), 2 * std::numbers::pi * (3 + 1), 1e-5);
}

TEST(EnvironmentMap, SaysOfItsSamplesWhatItSaysOfTheirDirections) {
  std::vector<EnvironmentMap> maps = hard_maps();
  for (const float rotation : {33.3F, -359.9F}) maps.emplace_back(sky(64, 32), rotation);
  for (const EnvironmentMap& map : maps) {
    for (std::uint32_t i = 0; i < 100000; ++i) {
      const auto sample = map.sample(transport::sobol_point(i, 3).xy());
      ASSERT_TRUE(sample);
      ASSERT_NEAR(sample->direction.length(), 1, 1e-6);
      ASSERT_EQ(sample->pdf, map.pdf(sample->direction)) << sample->direction;
      ASSERT_EQ(sample->radiance, map.radiance(sample->direction));
      ASSERT_GT(sample->pdf, 0);
      ASSERT_GT(sample->radiance.x, 0);
    }
  }
}

TEST(EnvironmentMap, TakesTheEndsOfTheUnitInterval) {
  constexpr float Last = 0x1.fffffep-1F;
  for (const EnvironmentMap& map : hard_maps()) {
    for (const Vec2f& xi : {Vec2f(0, 0), Vec2f(Last, 0), Vec2f(0, Last), Vec2f(Last, Last)}) {
      const auto sample = map.sample(xi);
      ASSERT_TRUE(sample && std::isfinite(sample->pdf));
      EXPECT_GT(sample->pdf, 0);
    }
  }
}

/// The p-value of direction counts against a pdf (chi-square), for four cells per texel.
double p_value(const EnvironmentMap& says, const EnvironmentMap& draws, int samples) {
  const Image& image = says.image();
  const int rows = 2 * image.height;
  const int columns = 2 * image.width;
  std::vector<double> counts(std::size_t(rows) * std::size_t(columns), 0.0);
  std::mt19937 random(9);
  const auto uniform = [&] { return static_cast<float>(random() >> 8U) * 0x1p-24F; };
  for (int i = 0; i < samples; ++i) {
    const float x = uniform();
    const Vec3f d = draws.sample(Vec2f(x, uniform()))->direction;
    const double theta = std::atan2(std::hypot(d.x, d.z), d.y);
    const double phi = std::atan2(d.x, -d.z);
    const int row = std::clamp(static_cast<int>(theta / std::numbers::pi * rows), 0, rows - 1);
    const int column =
        std::clamp(static_cast<int>((0.5 + phi / (2 * std::numbers::pi)) * columns), 0, columns - 1);
    counts[std::size_t(row) * std::size_t(columns) + std::size_t(column)] += 1;
  }
  double statistic = 0;
  int terms = 0;
  double pooled_expected = 0;
  double pooled_count = 0;
  for (int row = 0; row < rows; ++row) {
    const double solid_angle =
        2 * std::numbers::pi / columns *
        (std::cos(std::numbers::pi * row / rows) - std::cos(std::numbers::pi * (row + 1) / rows));
    for (int column = 0; column < columns; ++column) {
      const Vec3f direction(test::direction_at<double>(image, (column + 0.5) / 2, (row + 0.5) / 2));
      const double expected = samples * solid_angle * double(says.pdf(direction));
      const double counted = counts[std::size_t(row) * std::size_t(columns) + std::size_t(column)];
      if (expected < 5) {
        pooled_expected += expected;
        pooled_count += counted;
        continue;
      }
      statistic += (counted - expected) * (counted - expected) / expected;
      ++terms;
    }
  }
  if (pooled_expected > 1) {
    statistic += (pooled_count - pooled_expected) * (pooled_count - pooled_expected) / pooled_expected;
    ++terms;
  } else if (pooled_count > 20) {
    return 0;
  }
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(terms - 1), statistic));
}

TEST(EnvironmentMap, SamplesFollowTheirDensity) {
  const std::vector<EnvironmentMap> maps = hard_maps();
  for (std::size_t i = 0; i < maps.size(); ++i) {
    EXPECT_GT(p_value(maps[i], maps[i], 400000), 0.01 / double(maps.size())) << i;
  }
  // The test can fail.
  Image other = sky(64, 32);
  for (int x = 0; x < 64; ++x) other.pixels[std::size_t(64) * 10 + std::size_t(x)] *= 3;
  EXPECT_LT(p_value(maps.back(), EnvironmentMap(other), 400000), 1e-6);
}

// The map is continuous along a fine line of xi, up to the size of a step.
TEST(EnvironmentMap, InvertsContinuously) {
  const EnvironmentMap map(image_of(32, 16, [](int x, int y) { return 1.0F + float(x % 5) + float(y % 3); }));
  const int steps = 4096;
  for (const float other : {0.1F, 0.5F, 0.93F}) {
    for (int i = 1; i < steps; ++i) {
      const float before = static_cast<float>(i - 1) / steps;
      const float after = static_cast<float>(i) / steps;
      // Within a row. From row to row, columns may shift by as much as their distributions differ.
      const Vec3f step =
          map.sample(Vec2f(after, other))->direction - map.sample(Vec2f(before, other))->direction;
      ASSERT_LT(step.length(), 2 * std::numbers::pi / steps * 8) << i;
    }
  }
}

TEST(EnvironmentMap, StratifiedPointsHaveLessVariance) {
  const EnvironmentMap map(sky(64, 32));
  const auto squared_error = [&](auto pair_of) {
    const Vec3f axis = Vec3f(0.3F, 1, -0.2F).normalized();
    std::vector<double> means;
    for (std::uint32_t run = 0; run < 64; ++run) {
      double sum = 0;
      for (std::uint32_t i = 0; i < 256; ++i) {
        const auto sample = map.sample(pair_of(i, run));
        sum += std::max(0.0F, sample->direction.dot(axis)) * sample->radiance.x / sample->pdf / 256;
      }
      means.push_back(sum);
    }
    double mean = 0;
    for (const double value : means) mean += value / 64;
    double variance = 0;
    for (const double value : means) variance += (value - mean) * (value - mean) / 63;
    return variance;
  };
  std::mt19937 random(4);
  const auto uniform = [&] { return static_cast<float>(random() >> 8U) * 0x1p-24F; };
  const double independent = squared_error([&](std::uint32_t, std::uint32_t) {
    const float x = uniform();
    return Vec2f(x, uniform());
  });
  const double stratified =
      squared_error([](std::uint32_t i, std::uint32_t run) { return transport::sobol_point(i, run).xy(); });
  EXPECT_LT(stratified, independent / 20);
}

const std::vector<Vec3f> Normals = {Vec3f(0, 1, 0), Vec3f(0, -1, 0), Vec3f(0.6F, 0.64F, 0.48F),
                                    Vec3f(-0.36F, 0.48F, -0.8F)};

TEST(EnvironmentForASurface, SaysOfItsSamplesWhatItSaysOfTheirDirections) {
  for (const EnvironmentMap& map : hard_maps()) {
    for (const Vec3f& normal : Normals) {
      int differ = 0;
      constexpr std::uint32_t Count = 20000;
      for (std::uint32_t i = 0; i < Count; ++i) {
        const auto sample = map.sample(normal, transport::sobol_point(i, 3).xy());
        ASSERT_TRUE(sample);
        ASSERT_GT(sample->pdf, 0);
        ASSERT_EQ(sample->radiance, map.radiance(sample->direction));
        const float pdf = map.pdf(normal, sample->direction);
        if (std::abs(pdf - sample->pdf) > 1e-5F * pdf) ++differ;
      }
      // Directions that rounding moves across a step of the pdf.
      EXPECT_LE(differ, 20) << map.image().width << " " << normal;
    }
  }
}

// The same integral as by the map only, with less variance: directions below the horizon are hardly sampled.
TEST(EnvironmentForASurface, DrawsWhatIsOverTheHorizon) {
  const EnvironmentMap map(sky(64, 32));
  for (const Vec3f& normal : Normals) {
    std::array<double, 2> mean = {0, 0};
    std::array<double, 2> square = {0, 0};
    constexpr std::uint32_t Count = 65536;
    for (std::uint32_t i = 0; i < Count; ++i) {
      const Vec2f xi = transport::sobol_point(i, 5).xy();
      const auto add = [&](std::size_t way, const transport::EnvironmentSample& sample) {
        const double value =
            double(std::max(0.0F, sample.direction.dot(normal)) * sample.radiance.x) / double(sample.pdf);
        mean[way] += value / Count;
        square[way] += value * value / Count;
      };
      add(0, *map.sample(xi));
      add(1, *map.sample(normal, xi));
    }
    EXPECT_NEAR(mean[1] / mean[0], 1, 2e-3) << normal;
    EXPECT_LT(square[1] - mean[1] * mean[1], 0.3 * (square[0] - mean[0] * mean[0])) << normal;
  }
}

// Warped uniform samples hit each of the square's cells as often as their pdf says.
TEST(CosineWarps, WarpWithTheirDensity) {
  const EnvironmentMap map(sky(64, 32));
  const transport::CosineWarps warps([&](const Vec2f& xi) { return map.sample(xi)->direction; });
  for (const Vec3f& normal : Normals) {
    constexpr int Cells = 32;
    std::vector<int> counts(Cells * Cells, 0);
    constexpr std::uint32_t Count = 1 << 20;
    for (std::uint32_t i = 0; i < Count; ++i) {
      const Vec2f xi = warps.warp(normal, transport::sobol_point(i, 8).xy()).xi;
      ++counts[static_cast<std::size_t>(xi.y * Cells) * Cells + static_cast<std::size_t>(xi.x * Cells)];
    }
    double sum = 0;
    for (int cell = 0; cell < Cells * Cells; ++cell) {
      const Vec2f middle((static_cast<float>(cell % Cells) + 0.5F) / Cells,
                         (static_cast<float>(cell / Cells) + 0.5F) / Cells);
      const double expected = double(warps.pdf(normal, middle)) / (Cells * Cells);
      sum += expected;
      ASSERT_NEAR(counts[static_cast<std::size_t>(cell)] / double(Count), expected, 2e-5 + 0.05 * expected);
    }
    EXPECT_NEAR(sum, 1, 1e-5);
  }
}

TEST(EnvironmentMap, ThatIsBlackHasNoSamples) {
  const EnvironmentMap map(image_of(4, 2, [](int, int) { return 0.0F; }));
  EXPECT_TRUE(map.is_black());
  EXPECT_FALSE(map.sample(Vec2f(0.5F, 0.5F)));
  EXPECT_FALSE(map.sample(Vec3f(0, 1, 0), {0.5F, 0.5F}));
  EXPECT_EQ(map.pdf({0, 1, 0}), 0);
  EXPECT_EQ(map.radiance({0, 1, 0}), Rgb(0));
}

TEST(EnvironmentMap, ReportsTexelsThatCannotBe) {
  test::TemporaryFolder folder;
  const float texels[4] = {1, -1, std::nanf(""), std::numeric_limits<float>::infinity()};
  std::string pfm = "Pf\n4 1\n-1\n";
  pfm.append(reinterpret_cast<const char*>(texels), sizeof(texels));
  const std::string path = folder.add("map.pfm", pfm);
  grf::Diagnostics diagnostics;
  const auto map = transport::read_environment_map(path, diagnostics);
  ASSERT_TRUE(map);
  EXPECT_EQ(diagnostics.to_text(), path +
                                       ": warning: 3 of 4 texels of the environment map are negative or "
                                       "not finite, and count as 0 there\n");
  EXPECT_EQ(map->image().pixels, (std::vector<Rgb>{Rgb(1), Rgb(0), Rgb(0), Rgb(0)}));
  EXPECT_NEAR(map->pdf({-1e-3F, 0, 1}), 1 / std::numbers::pi, 1e-6);  // a quarter of the sphere
}

}  // namespace
