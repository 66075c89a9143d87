#pragma once

#include <vector>

#include "renderer/reflectance/geometry.h"

namespace reflectance {

/// Returns what light of one wavelength in nanometres is to the CIE 1931 observer, as linear sRGB with
/// negative channels, by the fit of Wyman, Sloan and Shirley 2013 ("Simple Analytic Approximations to the CIE
/// XYZ Color Matching Functions"). 1 W of any wavelength has about the luminance of the fit, at most 1.
Imath::V3d rgb_of_wavelength(double nanometres);

/// Returns a row of weights for each of R, G and B that turn a reflectance, given at ascending wavelengths in
/// nanometres and linear between them, into linear sRGB: under light of equal energy that is balanced to
/// white. Each row sums to 1, so that a grey reflectance has that value in all channels. Beyond its first
/// and last wavelength, the reflectance is constant.
std::vector<std::vector<double>> rgb_weights(const std::vector<float>& wavelengths);

}  // namespace reflectance
