// The daylight model, compared with an evaluation of the paper's formulas by another program.
#include "renderer/sky/daylight.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/support/paths.h"

namespace {

using grf::Vec3d;
using sky::Daylight;
using std::numbers::pi;

constexpr double Degree = pi / 180;

/// preetham.csv is what preetham.py prints.
TEST(Daylight, IsThatOfThePaper) {
  std::ifstream file(GRANADA_SOURCE_DIR "/tests/sky/preetham.csv");
  std::string line;
  std::getline(file, line);
  int lines = 0;
  while (std::getline(file, line)) {
    std::istringstream numbers(line);
    std::vector<double> v;
    for (std::string number; std::getline(numbers, number, ',');) v.push_back(std::stod(number));
    ASSERT_EQ(v.size(), 7U);
    ++lines;
    const Daylight daylight(v[0], v[1]);
    if (v[2] < 0) {
      const Vec3d sun = daylight.sun();
      // The colour-matching functions are printed with three digits in either form.
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(sun[k], v[4 + static_cast<std::size_t>(k)], 0.004 * v[5]) << line;
      continue;
    }
    const Vec3d light = daylight.sky(v[2] * Degree, v[3] * Degree);
    const double sum = light.x + light.y + light.z;
    EXPECT_NEAR(light.x / sum, v[4], 1e-5) << line;
    EXPECT_NEAR(light.y / sum, v[5], 1e-5) << line;
    EXPECT_NEAR(light.y, v[6], 1e-5 * v[6]) << line;
    if (v[2] == 0) {
      EXPECT_NEAR((daylight.zenith() - light).length(), 0, 1e-9);
    }
  }
  EXPECT_EQ(lines, 4 * 3 * 13);
}

/// The illuminance of a horizontal surface by the sky, by the midpoint rule.
double by_sky(const Daylight& daylight, double elevation) {
  double sum = 0;
  constexpr int Rows = 90;
  constexpr int Columns = 180;
  for (int row = 0; row < Rows; ++row) {
    const double theta = (row + 0.5) * Degree;
    for (int column = 0; column < Columns; ++column) {
      const double phi = (column + 0.5) * 2 * pi / Columns;
      const double sun = (90 - elevation) * Degree;
      const double cosine = std::cos(theta) * std::cos(sun) + std::sin(theta) * std::sin(sun) * std::cos(phi);
      sum += daylight.sky(theta, std::acos(cosine)).y * std::cos(theta) * std::sin(theta);
    }
  }
  return sum * Degree * 2 * pi / Columns;
}

/// A clear sky and its sun (Illuminating Engineering Society, RP-21-84): 127.5 exp(-0.21 m) klux for the sun,
/// with m = 1 / sin h, and 0.8 + 15.5 sqrt(sin h) klux for the sky, both on average.
TEST(Daylight, IlluminatesAsMeasured) {
  for (const double elevation : {20.0, 40.0, 60.0, 80.0}) {
    const double sine = std::sin(elevation * Degree);
    const Daylight clear(elevation, 2.5);
    const double sun = clear.sun().y * sine;
    const double sky = by_sky(clear, elevation);
    const double expected_sun = 127.5 * std::exp(-0.21 / sine) * sine;
    const double expected_sky = 0.8 + 15.5 * std::sqrt(sine);
    EXPECT_NEAR(sun, expected_sun, 0.25 * expected_sun) << elevation;
    EXPECT_NEAR(sun + sky, expected_sun + expected_sky, 0.25 * (expected_sun + expected_sky)) << elevation;
    // The model's clear sky is up to twice as bright as the average one.
    EXPECT_GT(sky, expected_sky) << elevation;
    EXPECT_LT(sky, 2.1 * expected_sky) << elevation;
  }
}

TEST(Daylight, HasAClearerAndBluerSkyWhereTheAirIsClear) {
  const Daylight clear(45, 2);
  const Daylight hazy(45, 6);
  // Angstrom's law at 555 nm, where the eye is the most sensitive.
  const double mass = 1 / (std::sin(45 * Degree) + 0.15 * std::pow(93.885 - 45, -1.253));
  EXPECT_NEAR(clear.sun().y / hazy.sun().y, std::exp(4 * 0.04608 * std::pow(0.555, -1.3) * mass), 0.05);
  EXPECT_GT(hazy.sky(0.7, 0.1).y, clear.sky(0.7, 0.1).y);
  const auto blueness = [](const Vec3d& xyz) { return xyz.z / xyz.y; };
  EXPECT_GT(blueness(clear.zenith()), blueness(hazy.zenith()));
  EXPECT_LT(blueness(Daylight(3, 3).sun()), 0.6 * blueness(Daylight(70, 3).sun())) << "a low sun is red";
}

}  // namespace
