// The colour of spectra: CIE 1931 and sRGB.
#pragma once

#include <cmath>

#include "grf/math.h"

namespace grf {

/// The CIE 1931 colour-matching functions at a wavelength in nm, as sums of Gaussians that differ from the
/// table by less than 1 % of its largest value (Wyman, Sloan and Shirley 2013, "Simple Analytic
/// Approximations to the CIE XYZ Color Matching Functions").
inline Vec3d cie_matching_functions(double nm) {
  // A Gaussian with a standard deviation below its mean and another one above, in nm.
  const auto lobe = [nm](double mean, double below, double above) {
    const double t = (nm - mean) / (nm < mean ? below : above);
    return std::exp(-t * t / 2);
  };
  return {1.056 * lobe(599.8, 37.9, 31.0) + 0.362 * lobe(442.0, 16.0, 26.7) - 0.065 * lobe(501.1, 20.4, 26.2),
          0.821 * lobe(568.8, 46.9, 40.5) + 0.286 * lobe(530.9, 16.3, 31.1),
          1.217 * lobe(437.0, 11.8, 36.0) + 0.681 * lobe(459.0, 26.0, 13.8)};
}

/// Planck's law in any unit: only ratios matter.
inline double planck(double nm, double kelvin) {
  constexpr double SecondRadiationConstant = 1.438776877e7;  // h c / k in nm K
  const double x = nm / 560;
  return 1 / (x * x * x * x * x * std::expm1(SecondRadiationConstant / (nm * kelvin)));
}

/// Linear sRGB (IEC 61966-2-1), with white D65.
inline Vec3d srgb_of_xyz(const Vec3d& xyz) {
  return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
          -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
          0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

/// The inverse of `srgb_of_xyz`.
inline Vec3d xyz_of_srgb(const Vec3d& rgb) {
  return {0.4124564 * rgb.x + 0.3575761 * rgb.y + 0.1804375 * rgb.z,
          0.2126729 * rgb.x + 0.7151522 * rgb.y + 0.0721750 * rgb.z,
          0.0193339 * rgb.x + 0.1191920 * rgb.y + 0.9503041 * rgb.z};
}

}  // namespace grf
