#include "renderer/sky/daylight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "grf/cie_colour.h"

namespace sky {
namespace {

using grf::Vec3d;

using std::numbers::pi;

/// A coefficient that is linear in the turbidity.
struct Line {
  double slope, offset;
  double at(double turbidity) const { return slope * turbidity + offset; }
};

// The tables of appendix A.2.
constexpr std::array<Line, 5> LuminanceLines = {
    Line{0.1787, -1.4630}, {-0.3554, 0.4275}, {-0.0227, 5.3251}, {0.1206, -2.5771}, {-0.0670, 0.3703}};
constexpr std::array<Line, 5> XLines = {
    Line{-0.0193, -0.2592}, {-0.0665, 0.0008}, {-0.0004, 0.2125}, {-0.0641, -0.8989}, {-0.0033, 0.0452}};
constexpr std::array<Line, 5> YLines = {
    Line{-0.0167, -0.2608}, {-0.0950, 0.0092}, {-0.0079, 0.2102}, {-0.0441, -1.6537}, {-0.0109, 0.0529}};

/// Rows are by falling powers of the turbidity, columns by falling powers of the sun's angle.
using Chromaticity = std::array<std::array<double, 4>, 3>;
constexpr Chromaticity ZenithX = {{{0.00166, -0.00375, 0.00209, 0},
                                   {-0.02903, 0.06377, -0.03202, 0.00394},
                                   {0.11693, -0.21196, 0.06052, 0.25886}}};
constexpr Chromaticity ZenithY = {{{0.00275, -0.00610, 0.00317, 0},
                                   {-0.04214, 0.08970, -0.04153, 0.00516},
                                   {0.15346, -0.26756, 0.06670, 0.26688}}};

double zenith_chromaticity(const Chromaticity& table, double turbidity, double angle) {
  double sum = 0;
  for (const auto& row : table) {
    const double inner = ((row[0] * angle + row[1]) * angle + row[2]) * angle + row[3];
    sum = sum * turbidity + inner;
  }
  return sum;
}

double zenith_luminance(double turbidity, double angle) {
  const double chi = (4.0 / 9 - turbidity / 120) * (pi - 2 * angle);
  return (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192;
}

Vec3d xyz_of(double x, double y, double luminance) {
  return {x / y * luminance, luminance, (1 - x - y) / y * luminance};
}

/// The mass of the air along the sun's rays over that at the zenith.
double optical_mass(double zenith_angle) {
  const double degrees = zenith_angle * 180 / pi;
  return 1 / (std::cos(zenith_angle) + 0.15 * std::pow(93.885 - degrees, -1.253));
}

}  // namespace

double Daylight::Distribution::value(double zenith_angle, double sun_angle) const {
  const double cosine = std::max(std::cos(zenith_angle), 1e-4);
  const double towards_sun = std::cos(sun_angle);
  return (1 + a * std::exp(b / cosine)) * (1 + c * std::exp(d * sun_angle) + e * towards_sun * towards_sun);
}

Daylight::Daylight(double sun_elevation, double turbidity)
    : sun_zenith_angle_((90 - sun_elevation) * pi / 180), turbidity_(turbidity) {
  const auto distribution = [&](const std::array<Line, 5>& lines, double zenith) {
    return Distribution{lines[0].at(turbidity), lines[1].at(turbidity), lines[2].at(turbidity),
                        lines[3].at(turbidity), lines[4].at(turbidity), zenith};
  };
  luminance_ = distribution(LuminanceLines, zenith_luminance(turbidity, sun_zenith_angle_));
  x_ = distribution(XLines, zenith_chromaticity(ZenithX, turbidity, sun_zenith_angle_));
  y_ = distribution(YLines, zenith_chromaticity(ZenithY, turbidity, sun_zenith_angle_));
}

Vec3d Daylight::zenith() const { return xyz_of(x_.zenith, y_.zenith, luminance_.zenith); }

Vec3d Daylight::sky(double zenith_angle, double sun_angle) const {
  const auto at = [&](const Distribution& one) {
    return one.zenith * one.value(zenith_angle, sun_angle) / one.value(0, sun_zenith_angle_);
  };
  // The fit of a low sun is below 0 in few directions.
  return xyz_of(at(x_), at(y_), std::max(at(luminance_), 0.0));
}

Vec3d Daylight::sun() const {
  constexpr double AboveTheAir = 127.5;  // klux
  constexpr double Temperature = 5778;   // K
  const double mass = optical_mass(sun_zenith_angle_);
  const double aerosols = 0.04608 * turbidity_ - 0.04586;  // Angstrom's beta; his alpha is 1.3
  Vec3d arriving(0);
  double above = 0;
  for (int nm = 360; nm <= 830; nm += 5) {
    const Vec3d matched = grf::cie_matching_functions(nm) * grf::planck(nm, Temperature);
    const double micrometres = nm * 1e-3;
    const double molecules = std::exp(-0.008735 * std::pow(micrometres, -4.08) * mass);
    arriving += matched * (molecules * std::exp(-aerosols * std::pow(micrometres, -1.3) * mass));
    above += matched.y;
  }
  return arriving * (AboveTheAir / above);
}

}  // namespace sky
