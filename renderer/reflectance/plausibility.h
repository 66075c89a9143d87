// Measured and tabulated BRDFs are checked for what physics asks of them: the same value for both orders of
// the directions (reciprocity), no more light than there was (energy), and a value that is not negative
// everywhere.
#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "renderer/reflectance/reflector.h"

namespace reflectance {

/// Returns the state of a BRDF's data; models without a file are sound.
DataState data_state(const Brdf& brdf, const Vec3f& u, const Vec3f& v);

/// Numbers over the angles of both directions from the normal, in cells of two degrees.
class AngleMap {
 public:
  static constexpr std::size_t Side = 45;
  static constexpr double CellDegrees = 90.0 / Side;

  /// Returns the angle at the centre of the cells of a row or column, in degrees.
  static double degrees(std::size_t index) { return (static_cast<double>(index) + 0.5) * CellDegrees; }

  /// Returns the value for the indices of a view and a light.
  double& at(std::size_t view, std::size_t light) { return values_[view * Side + light]; }
  double at(std::size_t view, std::size_t light) const { return values_[view * Side + light]; }

 private:
  std::array<double, Side* Side> values_ = {};
};

/// A pair of directions with the BRDF's value for it and for the pair in the other order, in 1/sr.
struct SwappedPair {
  Vec3f u = Vec3f(0);
  Vec3f v = Vec3f(0);
  Rgb value = Rgb(0);
  Rgb swapped = Rgb(0);
};

/// A check's result tells what a BRDF violates, and where. Fractions are of the pairs of directions, weighted
/// by both cosines.
struct Plausibility {
  AngleMap asymmetry;         ///< mean of |f(u,v) - f(v,u)| over the mean of both, over azimuths
  AngleMap missing;           ///< fraction of azimuths
  AngleMap negative;          ///< fraction of azimuths
  double mean_asymmetry = 0;  ///< of all pairs, as in the map
  double missing_fraction = 0;
  double negative_fraction = 0;
  SwappedPair worst_pair;  ///< the largest difference of the mean channel, weighted by both cosines
  grf::LargestAlbedo largest_albedo;

  /// Whether the two orders differ by more than rounding: by 0.1 % in the mean.
  bool is_reciprocal() const { return mean_asymmetry <= 1e-3; }
  /// Whether no albedo is over 1 by more than 0.01, the accuracy of `largest_albedo`.
  bool conserves_energy() const { return largest_albedo.albedo <= 1.01F; }
};

/// The value f in 1/sr, and the state of the data, of a pair of directions above the horizon.
struct CheckedValue {
  Rgb value;
  DataState state = DataState::Sound;
};

/// Compares the values at the angles of the maps and at 32 azimuths between both directions, and at 8 of the
/// view if the BRDF is anisotropic. The albedo is not computed.
Plausibility check_values(const std::function<CheckedValue(const Vec3f& u, const Vec3f& v)>& brdf,
                          bool is_anisotropic);

/// Checks the values of a BRDF without its delta part, which is reciprocal by its definition, and its albedo
/// with it.
Plausibility check_plausibility(const Brdf& brdf);

}  // namespace reflectance
