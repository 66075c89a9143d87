#include "editor/document/blackbody.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace editor {
namespace {

TEST(Blackbody, HasThePublishedChromaticities) {
  struct Published {
    double kelvin, x, y;
  };
  // CIE 15: illuminant A is a black body of 2856 K. The others are points of the Planckian locus in Wyszecki
  // and Stiles, Color Science, table 1(3.11). The fit is within 0.005.
  for (const Published& point :
       {Published{2856, 0.4476, 0.4074}, Published{2000, 0.5267, 0.4133}, Published{4000, 0.3805, 0.3768},
        Published{6500, 0.3135, 0.3237}, Published{10000, 0.2807, 0.2884}}) {
    const grf::Vec2d xy = chromaticity_of(blackbody_colour(point.kelvin));
    EXPECT_NEAR(xy.x, point.x, 0.004) << point.kelvin;
    EXPECT_NEAR(xy.y, point.y, 0.004) << point.kelvin;
  }
}

TEST(Blackbody, HasLuminanceOneAndNoNegativeChannel) {
  for (double kelvin = LeastTemperature; kelvin <= LargestTemperature; kelvin *= 1.3) {
    const grf::Vec3d colour = blackbody_colour(kelvin);
    // The luminance of IEC 61966-2-1.
    EXPECT_NEAR(0.2126 * colour.x + 0.7152 * colour.y + 0.0722 * colour.z, 1, 1e-3) << kelvin;
    EXPECT_GE(std::min({colour.x, colour.y, colour.z}), 0) << kelvin;
  }
  EXPECT_EQ(blackbody_colour(1200).z, 0);
  const grf::Vec3d daylight = blackbody_colour(6500);
  const double largest = std::max({daylight.x, daylight.y, daylight.z});
  EXPECT_NEAR(daylight.x / largest, 1, 0.001);
  EXPECT_NEAR(daylight.y / largest, 0.98, 0.04);
  EXPECT_NEAR(daylight.z / largest, 0.98, 0.04);
}

TEST(Blackbody, TemperatureIsFoundAgain) {
  for (const double kelvin : {1900.0, 2856.0, 4000.0, 6500.0, 12000.0}) {
    const auto found = temperature_of(grf::Colour(blackbody_colour(kelvin) * 7.3));
    ASSERT_TRUE(found) << kelvin;
    EXPECT_NEAR(*found, kelvin, 1) << kelvin;
  }
  EXPECT_FALSE(temperature_of(grf::Colour(0.2F, 1, 0.2F)));
  EXPECT_FALSE(temperature_of(grf::Colour(0)));
}

}  // namespace
}  // namespace editor
