// Environment maps as lights and a rest, compared with closed forms.
#include "renderer/studies/environment/map_lights.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/studies/angles.h"
#include "renderer/studies/environment/file.h"
#include "tests/studies/filled_image.h"

namespace {

using image::Image;
using reflectance::Rgb;
using reflectance::Vec3f;
using std::numbers::pi;
using studies::Degree;
using studies::map_lights;
using studies::MapLights;
using test::filled;

constexpr int Width = 720;  // half a degree per texel
constexpr int Height = 360;

/// Fills a rectangle of texels, whose right and lower borders are outside.
void fill(Image& image, int left, int top, int right, int bottom, const Rgb& radiance) {
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) image.pixels[static_cast<std::size_t>(y * image.width + x)] = radiance;
  }
}

/// The closed form: 2 pi / width for each column times the difference of cosines.
double solid_angle(int left, int top, int right, int bottom) {
  return 2 * pi * (right - left) / Width * (std::cos(pi * top / Height) - std::cos(pi * bottom / Height));
}

double degrees_between(const Vec3f& a, const Vec3f& b) {
  return std::acos(std::min(1.0, Imath::V3d(a).dot(Imath::V3d(b)))) / Degree;
}

TEST(MapLights, HoldASunWithWhatTheLimitLeavesOfIt) {
  Image image = filled(Width, Height, Rgb(0));
  // Two degrees wide at 90 degrees from the centre towards +x, 30 degrees over the horizon.
  fill(image, 538, 118, 542, 122, {1000, 800, 500});
  const MapLights found = map_lights(image);
  ASSERT_EQ(found.lights.size(), 1U);
  const Vec3f expected(static_cast<float>(std::cos(30 * Degree)), 0.5F, 0);
  EXPECT_LT(degrees_between(found.lights[0].direction, expected), 0.05) << "lower texels are larger";
  const double sun = solid_angle(538, 118, 542, 122);
  const Rgb rest = studies::below_limit({1000, 800, 500}, found.limit);
  const double luminance = 0.2126 * 1000 + 0.7152 * 800 + 0.0722 * 500;
  EXPECT_NEAR(double(found.limit), 16 * luminance * sun / (4 * pi), 1e-3);
  const Rgb all = found.lights[0].irradiance + rest * static_cast<float>(sun);
  EXPECT_NEAR(double(all.x), 1000 * sun, 1e-3 * sun * 1000);
  EXPECT_NEAR(double(all.y), 800 * sun, 1e-3 * sun * 800);
  EXPECT_NEAR(double(all.z), 500 * sun, 1e-3 * sun * 500);
  EXPECT_GT(found.lights[0].irradiance.x, 0.9 * 1000 * sun);
}

/// The irradiance of a horizontal surface under a cap of half-angle a about the zenith is pi L sin^2 a.
TEST(MapLights, ShineOnASurfaceAsTheMapDoes) {
  Image image = filled(Width, Height, Rgb(0));
  fill(image, 0, 0, Width, 24, Rgb(2000));  // 12 degrees
  const MapLights found = map_lights(image);
  EXPECT_GT(found.lights.size(), 8U);
  const double cap = pi * std::pow(std::sin(12 * Degree), 2);
  double irradiance = double(studies::below_limit(Rgb(2000), found.limit).x) * cap;
  for (const auto& light : found.lights) irradiance += double(light.irradiance.x) * double(light.direction.y);
  EXPECT_NEAR(irradiance, 2000 * cap, 0.005 * 2000 * cap);
}

TEST(MapLights, AreNoneUnderAnOvercastSky) {
  Image image = filled(64, 32, Rgb(0.1F));
  for (int y = 0; y < 16; ++y)
    fill(image, 0, y, 64, y + 1, Rgb(static_cast<float>((1 + 2 * std::cos(pi * (y + 0.5) / 32)) / 3)));
  EXPECT_TRUE(map_lights(image).lights.empty());
  EXPECT_TRUE(map_lights(filled(64, 32, Rgb(0))).lights.empty());
}

/// A strip along the horizon is cut into halves of equal energy, and these again (Debevec 2005, section 2).
TEST(MapLights, DivideTheEnergyEvenly) {
  Image image = filled(Width, Height, Rgb(0));
  fill(image, 320, 178, 400, 182, Rgb(50));  // 40 by 2 degrees about -z
  const MapLights found = map_lights(image, 4);
  ASSERT_EQ(found.lights.size(), 4U);
  std::vector<double> azimuths;
  float sum = 0;
  for (const auto& light : found.lights) {
    azimuths.push_back(std::atan2(double(light.direction.x), -double(light.direction.z)) / Degree);
    sum += light.irradiance.x;
  }
  std::ranges::sort(azimuths);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(azimuths[i], -15 + 10 * static_cast<double>(i), 0.3);
    EXPECT_NEAR(found.lights[i].irradiance.x, sum / 4, 0.01F * sum);
  }
}

TEST(ReducedMap, KeepsTheLightOfALargeOne) {
  Image image = filled(4096, 2048, Rgb(0.25F));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  fill(image, 8, 1020, 12, 1028, Rgb(100));
  fill(image, 3000, 700, 3001, 701, {nan, -1, 7});
  const Image reduced = studies::reduced_map(image);
  ASSERT_EQ(reduced.width, 2048);
  ASSERT_EQ(reduced.height, 1024);
  EXPECT_NEAR(double(reduced.at(5, 512).x), 100, 1e-3);
  EXPECT_NEAR(double(reduced.at(3, 512).x), 0.25, 1e-6);
  EXPECT_NEAR(double(reduced.at(1500, 350).x), 0.1875, 1e-4) << "one of four texels is 0";
  EXPECT_NEAR(double(reduced.at(1500, 350).z), (3 * 0.25 + 7) / 4, 0.01);
  const Image small = filled(64, 32, Rgb(3));
  EXPECT_EQ(studies::reduced_map(small).pixels, small.pixels);
}

}  // namespace
