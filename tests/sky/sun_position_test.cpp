// The sun's position, compared with published values.
#include "renderer/sky/sun_position.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

using sky::PlaceAndTime;
using sky::sun_coordinates;

/// The stated accuracy, degrees.
constexpr double Accuracy = 0.01;

TEST(SunCoordinates, AreThoseOfMeeus) {
  // Meeus, "Astronomical Algorithms" (1991), example 24.a: 1992 October 13.0, apparent position by the
  // VSOP87.
  const PlaceAndTime at = {0, 0, 1992, 10, 13, 0, 0};
  EXPECT_DOUBLE_EQ(sky::days_since_2000(at), 2448908.5 - 2451545.0);
  const auto sun = sun_coordinates(sky::days_since_2000(at));
  EXPECT_NEAR(sun.right_ascension, 198.378178, Accuracy);
  EXPECT_NEAR(sun.declination, -7.783871, Accuracy);
}

TEST(SunPosition, IsThatOfTheExampleOfNrel) {
  // Reda and Andreas 2004, "Solar position algorithm for solar radiation applications", appendix A.5: the
  // elevation before refraction, from the surface of the earth.
  const sky::SunPosition sun = sky::sun_position({39.742476, -105.1786, 2003, 10, 17, 12 + 30.5 / 60, -7});
  EXPECT_NEAR(sun.azimuth, 194.340241, 2 * Accuracy);
  EXPECT_NEAR(sun.elevation, 39.872046, Accuracy);
}

/// Equinoxes and solstices of 2020 (U.S. Naval Observatory, "Earth's Seasons").
TEST(SunCoordinates, AreThoseOfTheSeasons) {
  struct Season {
    int month, day, hour, minute;
    double right_ascension, declination;
  };
  for (const Season& season : {Season{3, 20, 3, 50, 360, 0}, Season{6, 20, 21, 44, 90, 23.4366},
                               Season{9, 22, 13, 31, 180, 0}, Season{12, 21, 10, 2, 270, -23.4366}}) {
    const auto sun = sun_coordinates(
        sky::days_since_2000({0, 0, 2020, season.month, season.day, season.hour + season.minute / 60.0, 0}));
    EXPECT_NEAR(std::remainder(sun.right_ascension - season.right_ascension, 360), 0, Accuracy)
        << season.month;
    EXPECT_NEAR(sun.declination, season.declination, Accuracy) << season.month;
  }
}

/// The local time with its offset from UTC is what counts, and at the equinox the sun rises in the east.
TEST(SunPosition, FollowsTimeAndPlace) {
  const auto utc = sky::sun_position({41.4, 2.2, 2026, 6, 21, 10.5, 0});
  const auto local = sky::sun_position({41.4, 2.2, 2026, 6, 21, 12.5, 2});
  EXPECT_NEAR(utc.azimuth, local.azimuth, 1e-6);
  EXPECT_NEAR(utc.elevation, local.elevation, 1e-6);
  const auto after_midnight =
      sky::sun_position({35.7, 139.7, 2026, 6, 21, 8, 9});  // of the day before in UTC
  const auto before = sky::sun_position({35.7, 139.7, 2026, 6, 20, 23, 0});
  EXPECT_NEAR(after_midnight.elevation, before.elevation, 1e-6);
  const auto morning = sky::sun_position({0, 0, 2020, 3, 20, 7, 0});
  EXPECT_NEAR(morning.azimuth, 90, 0.1);
  EXPECT_NEAR(sky::sun_position({0, 0, 2020, 3, 20, 17, 0}).azimuth, 270.2, 0.1)
      << "half a day after the equinox";
  // In the south the sun of noon is in the north.
  const auto south = sky::sun_position({-33.9, 151.2, 2026, 6, 21, 12, 10});
  EXPECT_LT(std::abs(std::remainder(south.azimuth, 360)), 5);
  EXPECT_LT(sky::sun_position({60, 0, 2026, 12, 21, 0, 0}).elevation, -50);
}

}  // namespace
