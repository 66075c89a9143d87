#include "editor/document/blackbody.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace editor {
namespace {

using grf::Vec3d;

/// A Gaussian with a standard deviation below its mean and another one above, in nm.
double lobe(double wavelength, double mean, double below, double above) {
  const double t = (wavelength - mean) / (wavelength < mean ? below : above);
  return std::exp(-t * t / 2);
}

Vec3d matching_functions(double nm) {
  return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
              0.065 * lobe(nm, 501.1, 20.4, 26.2),
          0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
          1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

constexpr int Wavelengths = 95;
/// From 360 to 830 nm.
constexpr double nm_of(int wavelength) { return 360 + 5 * wavelength; }

/// Planck's law in any unit: only ratios matter.
double planck(double nm, double kelvin) {
  constexpr double SecondRadiationConstant = 1.438776877e7;  // h c / k in nm K
  const double x = nm / 560, x2 = x * x;
  return 1 / (x2 * x2 * x * std::expm1(SecondRadiationConstant / (nm * kelvin)));
}

Vec3d xyz_of(double kelvin) {
  // A search for a temperature needs them often.
  static const auto functions = [] {
    std::array<Vec3d, Wavelengths> values;
    for (int i = 0; i < Wavelengths; ++i) values[static_cast<std::size_t>(i)] = matching_functions(nm_of(i));
    return values;
  }();
  Vec3d xyz(0);
  for (int i = 0; i < Wavelengths; ++i)
    xyz += functions[static_cast<std::size_t>(i)] * planck(nm_of(i), kelvin);
  return xyz / xyz.y;
}

// IEC 61966-2-1, with white D65.
Vec3d rgb_of_xyz(const Vec3d& xyz) {
  return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
          -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
          0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

Vec3d xyz_of_rgb(const Vec3d& rgb) {
  return {0.4124564 * rgb.x + 0.3575761 * rgb.y + 0.1804375 * rgb.z,
          0.2126729 * rgb.x + 0.7151522 * rgb.y + 0.0721750 * rgb.z,
          0.0193339 * rgb.x + 0.1191920 * rgb.y + 0.9503041 * rgb.z};
}

double chromaticity_distance(const Vec3d& colour, double kelvin) {
  return (chromaticity_of(colour) - chromaticity_of(blackbody_colour(kelvin))).length();
}

}  // namespace

Vec3d blackbody_colour(double kelvin) {
  Vec3d rgb = rgb_of_xyz(xyz_of(kelvin));
  for (int channel = 0; channel < 3; ++channel) rgb[channel] = std::max(rgb[channel], 0.0);
  return rgb / xyz_of_rgb(rgb).y;
}

grf::Vec2d chromaticity_of(const Vec3d& colour) {
  const Vec3d xyz = xyz_of_rgb(colour);
  const double sum = xyz.x + xyz.y + xyz.z;
  return {xyz.x / sum, xyz.y / sum};
}

std::optional<double> temperature_of(const grf::Colour& colour) {
  const Vec3d wanted(colour);
  if (!(wanted.x > 0) || !(wanted.y > 0) || wanted.z < 0) return std::nullopt;
  // The distance has one minimum along the Planckian locus, where reciprocal temperatures are about equally
  // spaced: a ternary search.
  double low = 1e6 / LargestTemperature, high = 1e6 / LeastTemperature;
  while (high - low > 1e-4) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    if (chromaticity_distance(wanted, 1e6 / left) < chromaticity_distance(wanted, 1e6 / right)) {
      high = right;
    } else {
      low = left;
    }
  }
  const double kelvin = std::round(2e6 / (low + high));
  constexpr double Tolerance = 1e-4;  // in xy; a just noticeable difference is about 0.003
  return chromaticity_distance(wanted, kelvin) < Tolerance ? std::optional(kelvin) : std::nullopt;
}

}  // namespace editor
