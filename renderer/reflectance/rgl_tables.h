#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/reflectance/bilinear_warp.h"
#include "renderer/reflectance/tensor_file.h"

namespace reflectance {

/// How the azimuths of a file's view directions cover the circle.
enum class AzimuthRange {
  Isotropic,  ///< one or two azimuths: the BRDF does not depend on them
  Full,       ///< the whole circle
  Half,       ///< half of it, of a material that looks the same after half a turn
  Quarter     ///< one quadrant, of a material with mirror planes x = 0 and y = 0
};

/// The tables of an RGL file, for view directions at pairs of azimuth and angle from the normal. A half
/// vector (theta, phi) is at the point (sqrt(2 theta/pi), (phi + pi)/(2 pi)) of the unit square; in isotropic
/// files, phi is its azimuth minus that of the view direction.
struct RglTables {
  AzimuthRange range = AzimuthRange::Isotropic;
  double first_azimuth = 0;        ///< of the range, in radians; of an isotropic file, the mean azimuth
  SliceGrid views;                 ///< azimuth and angle from the normal, in radians
  BilinearTable ndf;               ///< distribution of microfacets D at the half vector, per steradian
  BilinearTable sigma;             ///< projected area of the microfacets at the view direction
  BilinearWarp visible;            ///< density of visible half vectors
  BilinearWarp luminance;          ///< density in which the uniform points of `visible` are drawn
  BilinearTable rgb;               ///< f cos/(D/(4 sigma)) at those uniform points, linear sRGB, may be < 0
  BilinearTable spectra;           ///< the same by wavelength; no table if there are no wavelengths
  std::vector<float> wavelengths;  ///< in nanometres, ascending; empty for an RGB file
  bool is_divided_by_ndf = true;   ///< false: `rgb` and `spectra` are f cos itself
  std::string description;         ///< as the file has it
};

/// Makes the tables of a file, or returns nothing and says in `error` which array is missing or has the wrong
/// type, shape or values. Negative or non-finite entries count as 0, except that colours may be negative.
std::optional<RglTables> read_rgl_tables(const TensorFile& file, std::string& error);

}  // namespace reflectance
