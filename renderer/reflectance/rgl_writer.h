#pragma once

#include <cstddef>
#include <string>

#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// The number of nodes of a BRDF's tables in the format of the RGL data base.
struct RglResolution {
  std::size_t angles = 24;        ///< of the view from the normal, 0 to 88 degrees
  std::size_t azimuths = 24;      ///< of the view around the normal; an isotropic BRDF has one
  std::size_t half_vectors = 64;  ///< along each side of the tables of microfacets
  std::size_t colours = 32;       ///< along each side of the tables of colours

  /// Returns the resolution with this many times the nodes along each axis.
  RglResolution times(double factor) const;
};

/// The colours of a file: some readers take linear sRGB only, and others spectra only.
enum class RglColours { LinearSrgb, Spectra };

/// Tabulates a BRDF as a file of the RGL data base (Dupuy and Jakob 2018, "An Adaptive Parameterization for
/// Efficient Material Acquisition and Rendering"): f cos(theta_v) over the density of an ideal microfacet
/// sampler, at points that the visible half vectors of each view warp. The microfacets are found from the
/// BRDF's retro-reflection, and are only a parameterisation: each of them leads to the same values at the
/// nodes. A delta part is left out. `RglData` reads the file.
///
/// Spectra are those of the BRDF if it has wavelengths (`wavelengths_of`), and else sums of three smooth
/// curves with its RGB, of which negative values are 0. An anisotropic BRDF is tabulated over the full turn.
/// All values are multiplied by a colour.
std::string rgl_file_of(const Brdf& brdf, const RglResolution& resolution, RglColours colours,
                        const std::string& description, const Rgb& colour = Rgb(1));

}  // namespace reflectance
