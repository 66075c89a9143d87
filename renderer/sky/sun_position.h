// The sun's position in the sky of a place at a time.
#pragma once

#include <numbers>

namespace sky {

/// A degree in radians.
constexpr double Degree = std::numbers::pi / 180;

/// A place on the earth, and a time there in the Gregorian calendar.
struct PlaceAndTime {
  double latitude = 48;  ///< degrees, north is positive
  double longitude = 0;  ///< degrees, east is positive
  int year = 2026;
  int month = 6;
  int day = 21;
  double hours = 12;      ///< local time of the day
  double utc_offset = 0;  ///< of the local time, in hours: positive in the east
};

/// Directions in degrees.
struct SunPosition {
  double azimuth = 0;    ///< from north over east, 0 to 360
  double elevation = 0;  ///< over the horizon, without refraction, which is up to 0.6 at the horizon
};

/// Computes the position by the low-precision formulas of the Astronomical Almanac (Michalsky 1988, "The
/// Astronomical Almanac's algorithm for approximate solar position (1950-2050)", Solar Energy 40 (3)): within
/// 0.01 degrees from 1950 to 2050.
SunPosition sun_position(const PlaceAndTime& at);

/// The sun among the stars.
struct SunCoordinates {
  double right_ascension = 0;  ///< degrees, 0 to 360
  double declination = 0;      ///< degrees
};
/// Computes the coordinates from the days since 2000 January 1, 12 h UTC.
SunCoordinates sun_coordinates(double days);

/// Returns the days from 2000 January 1, 12 h UTC, to a time.
double days_since_2000(const PlaceAndTime& at);

}  // namespace sky
