// Maps of a sky with its sun.
#include "renderer/sky/sky_map.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/sky/daylight.h"

namespace {

using grf::Vec3d;
using sky::SkyMap;
using sky::SkySettings;
using std::numbers::pi;

double luminance(const grf::Colour& rgb) {
  return 0.2126 * double(rgb.x) + 0.7152 * double(rgb.y) + 0.0722 * double(rgb.z);
}

/// A morning in Barcelona.
SkySettings morning() {
  SkySettings settings;
  settings.at = {41.4, 2.2, 2026, 4, 10, 10, 2};
  settings.width = 256;
  return settings;
}

struct Sums {
  double horizontal = 0;  ///< illuminance of the upper half
  double all = 0;         ///< luminance times solid angle
  Vec3d brightest = Vec3d(0);
};

/// Integrates a map: its centre looks down -z, its right is +x, and y is up.
Sums integrated(const image::Image& image) {
  Sums sums;
  double most = 0;
  for (int y = 0; y < image.height; ++y) {
    const double theta = pi * (y + 0.5) / image.height;
    const double solid_angle = 2 * pi / image.width * pi / image.height * std::sin(theta);
    for (int x = 0; x < image.width; ++x) {
      const double here = luminance(image.at(x, y));
      sums.all += here * solid_angle;
      if (theta < pi / 2) sums.horizontal += here * solid_angle * std::cos(theta);
      if (here <= most) continue;
      most = here;
      const double phi = 2 * pi * (x + 0.5) / image.width - pi;
      sums.brightest = {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
    }
  }
  return sums;
}

TEST(SkyMap, HasTheLightThatItStates) {
  const SkyMap map = sky::sky_map(morning());
  ASSERT_EQ(map.image.width, 256);
  ASSERT_EQ(map.image.height, 128);
  const Sums sums = integrated(map.image);
  const double total = map.sky_illuminance + map.sun_illuminance;
  EXPECT_NEAR(sums.horizontal, total, 0.01 * total);
  const sky::Daylight daylight(map.sun.elevation, 3);
  EXPECT_NEAR(map.sun_illuminance, daylight.sun().y * std::sin(map.sun.elevation * pi / 180), 1e-9);
  EXPECT_NEAR(map.brightness() * total / pi, 1, 0.05) << "a white horizontal surface";
  // Grey ground of 20 % reflects that illuminance.
  EXPECT_NEAR(luminance(map.image.at(7, 120)), 0.2 * total / pi, 0.01 * total);
}

/// The sun is where its azimuth and elevation say, from north over east.
TEST(SkyMap, TurnsWithTheDirectionOfNorth) {
  SkySettings settings = morning();
  const SkyMap map = sky::sky_map(settings);
  ASSERT_LT(map.sun.azimuth, 180) << "it is morning";
  const auto expected = [&map](double north) {
    const double a = (map.sun.azimuth - north) * pi / 180;
    const double e = map.sun.elevation * pi / 180;
    return Vec3d(std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a));
  };
  EXPECT_GT(expected(0).x, 0) << "east is +x";
  for (const double north : {0.0, 90.0, -35.0}) {
    settings.north = north;
    const Vec3d sun = integrated(sky::sky_map(settings).image).brightest;
    EXPECT_GT(sun.dot(expected(north)), std::cos(1.5 * pi / 180)) << north;
  }
  // North is -x if it is turned by 90 degrees counter-clockwise, and east is -z.
  EXPECT_LT(expected(90).z, 0);
}

TEST(SkyMap, HasTheSameSunAtAnyResolution) {
  SkySettings settings = morning();
  for (const int width : {64, 512, 2048}) {
    settings.width = width;
    const SkyMap map = sky::sky_map(settings);
    const Sums sums = integrated(map.image);
    const double total = map.sky_illuminance + map.sun_illuminance;
    EXPECT_NEAR(sums.horizontal, total, (width == 64 ? 0.05 : 0.01) * total) << width;
  }
}

TEST(SkyMap, SaysWhyThereIsNone) {
  const auto problem = [](const std::function<void(SkySettings&)>& change) {
    SkySettings settings = morning();
    change(settings);
    return sky::problem_of(settings);
  };
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_EQ(problem([](SkySettings&) {}), "");
  EXPECT_TRUE(has(problem([](SkySettings& s) { s.at.hours = 2; }), "below the horizon"));
  EXPECT_TRUE(has(problem([](SkySettings& s) { s.at.latitude = 91; }), "latitude"));
  EXPECT_TRUE(has(problem([](SkySettings& s) { s.at.longitude = -181; }), "longitude"));
  EXPECT_TRUE(has(problem([](SkySettings& s) { s.at.day = 31; }), "no day 2026-04-31"));
  EXPECT_TRUE(has(problem([](SkySettings& s) { s.at.year = 2051; }), "1950 to 2050"));
  EXPECT_TRUE(has(problem([](SkySettings& s) { s.at.hours = 24; }), "time"));
  EXPECT_TRUE(has(problem([](SkySettings& s) { s.at.utc_offset = 15; }), "UTC"));
  EXPECT_TRUE(has(problem([](SkySettings& s) { s.turbidity = 6.5; }), "turbidity is from 2 to 6"));
  EXPECT_TRUE(has(problem([](SkySettings& s) { s.width = 30; }), "width"));
}

}  // namespace
