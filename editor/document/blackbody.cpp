#include "editor/document/blackbody.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "grf/cie_colour.h"

namespace editor {
namespace {

using grf::Vec3d;

constexpr int Wavelengths = 95;
/// From 360 to 830 nm.
constexpr double nm_of(int wavelength) { return 360 + 5 * wavelength; }

Vec3d xyz_of(double kelvin) {
  // A search for a temperature needs them often.
  static const auto functions = [] {
    std::array<Vec3d, Wavelengths> values;
    for (int i = 0; i < Wavelengths; ++i)
      values[static_cast<std::size_t>(i)] = grf::cie_matching_functions(nm_of(i));
    return values;
  }();
  Vec3d xyz(0);
  for (int i = 0; i < Wavelengths; ++i)
    xyz += functions[static_cast<std::size_t>(i)] * grf::planck(nm_of(i), kelvin);
  return xyz / xyz.y;
}

double chromaticity_distance(const Vec3d& colour, double kelvin) {
  return (chromaticity_of(colour) - chromaticity_of(blackbody_colour(kelvin))).length();
}

}  // namespace

Vec3d blackbody_colour(double kelvin) {
  Vec3d rgb = grf::srgb_of_xyz(xyz_of(kelvin));
  for (int channel = 0; channel < 3; ++channel) rgb[channel] = std::max(rgb[channel], 0.0);
  return rgb / grf::xyz_of_srgb(rgb).y;
}

grf::Vec2d chromaticity_of(const Vec3d& colour) {
  const Vec3d xyz = grf::xyz_of_srgb(colour);
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
