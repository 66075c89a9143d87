#include "renderer/sky/sun_position.h"

#include <chrono>
#include <cmath>

namespace sky {
namespace {

double sin_of(double degrees) { return std::sin(degrees * Degree); }
double cos_of(double degrees) { return std::cos(degrees * Degree); }

/// Returns the same angle from 0 to 360 degrees.
double within_turn(double degrees) {
  const double rest = std::fmod(degrees, 360);
  return rest < 0 ? rest + 360 : rest;
}

}  // namespace

double days_since_2000(const PlaceAndTime& at) {
  using std::chrono::sys_days;
  using std::chrono::year_month_day;
  const year_month_day date{std::chrono::year(at.year), std::chrono::month(static_cast<unsigned>(at.month)),
                            std::chrono::day(static_cast<unsigned>(at.day))};
  const year_month_day epoch{std::chrono::year(2000), std::chrono::month(1), std::chrono::day(1)};
  const auto whole = (sys_days(date) - sys_days(epoch)).count();
  return static_cast<double>(whole) + (at.hours - at.utc_offset - 12) / 24;
}

SunCoordinates sun_coordinates(double days) {
  const double mean_longitude = 280.460 + 0.9856474 * days;
  const double mean_anomaly = 357.528 + 0.9856003 * days;
  const double longitude = mean_longitude + 1.915 * sin_of(mean_anomaly) + 0.020 * sin_of(2 * mean_anomaly);
  const double obliquity = 23.439 - 0.0000004 * days;
  const double ascension = std::atan2(cos_of(obliquity) * sin_of(longitude), cos_of(longitude)) / Degree;
  return {within_turn(ascension), std::asin(sin_of(obliquity) * sin_of(longitude)) / Degree};
}

SunPosition sun_position(const PlaceAndTime& at) {
  const double days = days_since_2000(at);
  const SunCoordinates sun = sun_coordinates(days);
  // Greenwich mean sidereal time in hours.
  const double sidereal = 6.697375 + 0.0657098242 * days + std::fmod(at.hours - at.utc_offset, 24);
  const double hour_angle = within_turn(15 * sidereal + at.longitude - sun.right_ascension);
  const double up = sin_of(sun.declination) * sin_of(at.latitude) +
                    cos_of(sun.declination) * cos_of(at.latitude) * cos_of(hour_angle);
  const double north = sin_of(sun.declination) * cos_of(at.latitude) -
                       cos_of(sun.declination) * sin_of(at.latitude) * cos_of(hour_angle);
  const double east = -cos_of(sun.declination) * sin_of(hour_angle);
  return {within_turn(std::atan2(east, north) / Degree), std::atan2(up, std::hypot(north, east)) / Degree};
}

}  // namespace sky
