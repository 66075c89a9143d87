#include "renderer/reflectance/observer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace reflectance {
namespace {

/// Evaluates a bell curve whose widths below and above its centre differ, in nanometres.
double bell(double wavelength, double centre, double below, double above) {
  const double deviations = (wavelength - centre) / (wavelength < centre ? below : above);
  return std::exp(-0.5 * deviations * deviations);
}

}  // namespace

Imath::V3d rgb_of_wavelength(double nanometres) {
  const double x = 1.056 * bell(nanometres, 599.8, 37.9, 31.0) + 0.362 * bell(nanometres, 442.0, 16.0, 26.7) -
                   0.065 * bell(nanometres, 501.1, 20.4, 26.2);
  const double y = 0.821 * bell(nanometres, 568.8, 46.9, 40.5) + 0.286 * bell(nanometres, 530.9, 16.3, 31.1);
  const double z = 1.217 * bell(nanometres, 437.0, 11.8, 36.0) + 0.681 * bell(nanometres, 459.0, 26.0, 13.8);
  return {3.2406 * x - 1.5372 * y - 0.4986 * z, -0.9689 * x + 1.8758 * y + 0.0415 * z,
          0.0557 * x - 0.2040 * y + 1.0570 * z};
}

std::vector<std::vector<double>> rgb_weights(const std::vector<float>& wavelengths) {
  constexpr int First = 360;
  constexpr int Last = 830;
  constexpr int StepsPerNanometre = 4;
  std::vector<std::vector<double>> rows(3, std::vector<double>(wavelengths.size()));
  Imath::V3d sums(0);
  for (int step = 0; step < (Last - First) * StepsPerNanometre; ++step) {
    const double wavelength = First + (step + 0.5) / StepsPerNanometre;
    const Imath::V3d rgb = rgb_of_wavelength(wavelength);
    const auto above = std::upper_bound(wavelengths.begin(), wavelengths.end(), wavelength);
    const auto right =
        std::min(static_cast<std::size_t>(above - wavelengths.begin()), wavelengths.size() - 1);
    const std::size_t left = above == wavelengths.begin() || above == wavelengths.end() ? right : right - 1;
    const double gap = double(wavelengths[right]) - double(wavelengths[left]);
    const double fraction = gap > 0 ? (wavelength - double(wavelengths[left])) / gap : 0;
    for (int k = 0; k < 3; ++k) {
      std::vector<double>& row = rows[static_cast<std::size_t>(k)];
      row[left] += (1 - fraction) * rgb[k];
      row[right] += fraction * rgb[k];
      sums[k] += rgb[k];
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    for (double& weight : rows[k]) weight /= sums[static_cast<int>(k)];
  }
  return rows;
}

}  // namespace reflectance
