#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "renderer/reflectance/measurements/measurement.h"

namespace reflectance {

/// Measured values at any pairs of directions, interpolated by the modified method of Shepard (Franke and
/// Nielson 1980, "Smooth interpolation of large sets of scattered data") among the nearest ones in half-angle
/// coordinates (Rusinkiewicz 1998). The result is reciprocal, and isotropic if the measurements are.
class ScatteredTable {
 public:
  static constexpr std::size_t NeighbourCount = 8;
  /// A pair of directions without a value this near has none of its own. A distance of 1 is about that from
  /// h = n to the horizon, and between equal and opposite directions.
  static constexpr double LargestDistance = 0.15;

  /// There must be a measurement, and all must be usable: see `remove_faulty`.
  explicit ScatteredTable(const std::vector<Measurement>& measurements);

  /// Interpolates among the nearest measurements: those that are exactly there, or else the eight nearest
  /// ones, weighted by (R - r)^2/(R r)^2 with the distances r and R that of the ninth.
  Rgb linear(const Imath::V3d& u, const Imath::V3d& v) const;
  /// Returns the value of the nearest measurement.
  Rgb nearest(const Imath::V3d& u, const Imath::V3d& v) const;
  /// Returns whether no measurement is near.
  bool is_missing(const Imath::V3d& u, const Imath::V3d& v) const;

  bool is_anisotropic() const { return !is_isotropic_; }

 private:
  class Index;

  bool is_isotropic_;
  std::shared_ptr<const Index> index_;
};

}  // namespace reflectance
