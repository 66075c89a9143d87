// The spectrum of a BRDF consists of its values at single wavelengths, where a model or data have more than
// RGB.
#pragma once

#include <vector>

#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// Returns the wavelengths by which a BRDF is defined, in nanometres and ascending: those of measured
/// spectra, the channels' wavelengths of `he` and `westin`, and those over which `thinfilm` sums. Empty if it
/// is defined in RGB alone.
std::vector<float> wavelengths_of(const Brdf& brdf);

/// Evaluates f(u, v) in 1/sr at each of these wavelengths, in nanometres. Measured spectra are linear between
/// their own wavelengths, and constant beyond. So are the colours of a model between the wavelengths of its
/// channels, which are 645, 525 and 445 nm unless the model has its own. `wavelengths_of` must not be empty.
std::vector<double> spectrum_of(const Brdf& brdf, const Imath::V3d& u, const Imath::V3d& v,
                                const std::vector<float>& wavelengths);

}  // namespace reflectance
