#include "renderer/sky/sky_map.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "grf/cie_colour.h"
#include "renderer/sky/daylight.h"

namespace sky {
namespace {

using grf::Vec3d;

using std::numbers::pi;

/// A texel's directions, of which it has the centre.
struct MapGrid {
  int width, height;

  double theta(double row) const { return row * pi / height; }
  Vec3d direction(double column, double row) const {
    const double phi = (column / width - 0.5) * 2 * pi;
    return {std::sin(theta(row)) * std::sin(phi), std::cos(theta(row)),
            -std::sin(theta(row)) * std::cos(phi)};
  }
  double solid_angle(int row) const {
    return 2 * pi / width * (std::cos(theta(row)) - std::cos(theta(row + 1)));
  }
  std::size_t texel_at(const Vec3d& direction) const {
    const double across = 0.5 + std::atan2(direction.x, -direction.z) / (2 * pi);
    const double down = std::acos(std::clamp(direction.y, -1.0, 1.0)) / pi;
    const int x = std::clamp(static_cast<int>(across * width), 0, width - 1);
    const int y = std::clamp(static_cast<int>(down * height), 0, height - 1);
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

Vec3d direction_of(const SunPosition& sun, double north) {
  const double azimuth = (sun.azimuth - north) * Degree;  // clockwise from -z
  const double elevation = sun.elevation * Degree;
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
          -std::cos(elevation) * std::cos(azimuth)};
}

/// Spreads the sun's light over the texels that its disc covers, by points that fill the disc evenly.
void add_sun(const MapGrid& grid, const Vec3d& to_sun, const Vec3d& irradiance, std::vector<Vec3d>& xyz) {
  constexpr int Points = 4096;
  constexpr double GoldenAngle = 2.39996322972865332;
  const Vec3d aside = std::abs(to_sun.y) < 0.9 ? Vec3d(0, 1, 0) : Vec3d(1, 0, 0);
  const Vec3d right = aside.cross(to_sun).normalized();
  const Vec3d up = to_sun.cross(right);
  for (int i = 0; i < Points; ++i) {
    const double radius = std::tan(SunDiameter / 2 * Degree) * std::sqrt((i + 0.5) / Points);
    const double angle = GoldenAngle * i;
    const Vec3d point = to_sun + right * (radius * std::cos(angle)) + up * (radius * std::sin(angle));
    const std::size_t texel = grid.texel_at(point.normalized());
    const double solid_angle = grid.solid_angle(static_cast<int>(texel) / grid.width);
    xyz[texel] += irradiance / (Points * solid_angle);
  }
}

/// Fills the rows over the horizon, and returns their irradiance of a horizontal surface.
Vec3d add_sky(const MapGrid& grid, const Daylight& daylight, const Vec3d& to_sun, std::vector<Vec3d>& xyz) {
  Vec3d irradiance(0);
  for (int row = 0; row < grid.height / 2; ++row) {
    const double top = std::sin(grid.theta(row));
    const double bottom = std::sin(grid.theta(row + 1));
    // The integral of the cosine over a texel.
    const double projected = pi / grid.width * (bottom * bottom - top * top);
    for (int column = 0; column < grid.width; ++column) {
      const Vec3d direction = grid.direction(column + 0.5, row + 0.5);
      const double sun_angle = std::acos(std::clamp(direction.dot(to_sun), -1.0, 1.0));
      const Vec3d light = daylight.sky(grid.theta(row + 0.5), sun_angle);
      xyz[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width) +
          static_cast<std::size_t>(column)] = light;
      irradiance += light * projected;
    }
  }
  return irradiance;
}

bool is_date(const PlaceAndTime& at) {
  return at.month > 0 && at.day > 0 &&
         std::chrono::year_month_day(std::chrono::year(at.year),
                                     std::chrono::month(static_cast<unsigned>(at.month)),
                                     std::chrono::day(static_cast<unsigned>(at.day)))
             .ok();
}

}  // namespace

double SkyMap::brightness() const {
  const double exact = pi / (sky_illuminance + sun_illuminance);
  const double unit = std::pow(10, std::floor(std::log10(exact)) - 1);
  return std::round(exact / unit) * unit;
}

std::string problem_of(const SkySettings& settings) {
  const PlaceAndTime& at = settings.at;
  if (!(std::abs(at.latitude) <= 90)) return "the latitude is from -90 to 90 degrees";
  if (!(std::abs(at.longitude) <= 180)) return "the longitude is from -180 to 180 degrees";
  if (!is_date(at)) return fmt::format("there is no day {:04}-{:02}-{:02}", at.year, at.month, at.day);
  if (at.year < 1950 || at.year > 2050) return "the sun's position is known from 1950 to 2050";
  if (!(at.hours >= 0 && at.hours < 24)) return "the time is from 0:00 to 23:59";
  if (!(std::abs(at.utc_offset) <= 14)) return "the offset from UTC is from -14 to 14 hours";
  if (!(settings.turbidity >= LeastTurbidity && settings.turbidity <= LargestTurbidity))
    return fmt::format("the turbidity is from {} to {}", LeastTurbidity, LargestTurbidity);
  if (!std::isfinite(settings.north)) return "the direction of north is no number";
  if (settings.width < 16 || settings.width > 8192 || settings.width % 4 != 0)
    return "the width of the map is a multiple of 4 from 16 to 8192";
  const SunPosition sun = sun_position(at);
  if (!(sun.elevation > 0))
    return fmt::format("the sun is {:.1f} degrees below the horizon, and the model is one of the day",
                       -sun.elevation);
  return {};
}

SkyMap sky_map(const SkySettings& settings) {
  SkyMap map;
  map.sun = sun_position(settings.at);
  const MapGrid grid = {settings.width, settings.width / 2};
  const Daylight daylight(map.sun.elevation, settings.turbidity);
  const Vec3d to_sun = direction_of(map.sun, settings.north);
  std::vector<Vec3d> xyz(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
  const Vec3d of_sky = add_sky(grid, daylight, to_sun, xyz);
  const Vec3d of_sun = daylight.sun() * to_sun.y;
  const Vec3d ground = (of_sky + of_sun) * (GroundReflectance / pi);
  const auto below = xyz.begin() + static_cast<std::ptrdiff_t>(grid.height / 2) * grid.width;
  std::fill(below, xyz.end(), ground);
  add_sun(grid, to_sun, daylight.sun(), xyz);
  map.sky_illuminance = of_sky.y;
  map.sun_illuminance = of_sun.y;
  map.image = {grid.width, grid.height, {}};
  map.image.pixels.reserve(xyz.size());
  for (const Vec3d& each : xyz) {
    const grf::Vec3f rgb(grf::srgb_of_xyz(each));
    // A saturated blue is outside of sRGB.
    map.image.pixels.emplace_back(std::max(rgb.x, 0.0F), std::max(rgb.y, 0.0F), std::max(rgb.z, 0.0F));
  }
  return map;
}

}  // namespace sky
