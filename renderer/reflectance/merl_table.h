#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/reflectance/geometry.h"
#include "renderer/reflectance/glsl_functions.h"

namespace reflectance {

/// Half-angle coordinates of two directions (Rusinkiewicz 1998).
struct HalfAngles {
  double theta_half = 0;        ///< theta of h, from the normal, 0 to pi/2
  double theta_difference = 0;  ///< theta of both directions, from h, 0 to pi/2
  double phi_difference = 0;    ///< azimuth about h, 0 to pi: those of u are half a turn away
};

/// Returns the angles of a pair of directions (Rusinkiewicz 1998).
template <class Real>
HalfAngles half_angles(const Imath::Vec3<Real>& u, const Imath::Vec3<Real>& v) {
  const Imath::Vec3<Real> sum = u + v;
  const Imath::Vec3<Real> difference = v - u;
  const Real length = std::sqrt(sum.dot(sum));
  const Real radius = std::sqrt(sum.x * sum.x + sum.y * sum.y);
  HalfAngles angles;
  angles.theta_half = glsl::atan2(radius, sum.z);
  // atan2 of both lengths: the cosine has no digits left near h, and the sine none at a right angle.
  angles.theta_difference = glsl::atan2(std::sqrt(difference.dot(difference)), length);
  // The frame of h has x down the meridian, y around the normal.
  if (!(length > 0)) return angles;  // opposite directions have no h, and are never both above the horizon
  const bool is_upright = radius < Real(1e-12) * length;
  const Real cosine = is_upright ? 1 : sum.x / radius;
  const Real sine = is_upright ? 0 : sum.y / radius;
  const Real x = ((cosine * difference.x + sine * difference.y) * sum.z - difference.z * radius) / length;
  const Real y = cosine * difference.y - sine * difference.x;
  if (x * x + y * y < Real(1e-24)) return angles;
  angles.phi_difference = glsl::atan2(y, x);
  if (angles.phi_difference < 0) angles.phi_difference += std::numbers::pi;
  return angles;
}

/// A pair of directions with these angles, h in the plane y = 0. They can be below the horizon.
struct DirectionPair {
  Imath::V3d u, v;
};
DirectionPair directions_of(const HalfAngles& angles);  ///< Returns a pair of directions with these angles.

/// A measured isotropic BRDF in the format of the MERL data base (Matusik, Pfister, Brand and McMillan 2003):
/// values at 90 x 90 x 180 angles of h and about it, finer towards h = n.
class MerlTable {
 public:
  static constexpr std::size_t HalfCount = 90;
  static constexpr std::size_t DifferenceCount = 90;
  static constexpr std::size_t AzimuthCount = 180;
  static constexpr std::size_t CellCount = HalfCount * DifferenceCount * AzimuthCount;

  /// Loads the table from a file, or returns nothing after an error: missing file, wrong size or dimensions.
  /// Cells that are negative or not finite are invalid.
  static std::shared_ptr<const MerlTable> load(const std::string& path, grf::Diagnostics& diagnostics,
                                               const grf::SourceLocation& asked_for_at = {});

  /// Returns whether bytes start with the dimensions of such a table.
  static bool sniff(std::string_view bytes);

  /// Reads the table from the bytes of a file at `path`, or returns nothing after an error there.
  static std::shared_ptr<const MerlTable> parse(std::string_view bytes, const std::string& path,
                                                grf::Diagnostics& diagnostics,
                                                const grf::SourceLocation& asked_for_at = {});

  /// Tabulates a function at the cells' centres; cells with a direction below the horizon are invalid.
  explicit MerlTable(const std::function<Rgb(const Vec3f& u, const Vec3f& v)>& brdf);

  /// Writes the table to a file, or reports an error and leaves an existing file unchanged.
  bool write(const std::string& path, grf::Diagnostics& diagnostics) const;

  /// Looks up the nearest cell, 0 if it is invalid, as the data base's own reader does.
  Rgb nearest(const HalfAngles& angles) const;

  /// Returns true if a channel of the nearest cell is invalid.
  bool is_missing(const HalfAngles& angles) const;

  /// Interpolates trilinearly between the eight cells' centres, without invalid ones; 0 if all are invalid.
  Rgb linear(const HalfAngles& angles) const;

  /// Returns the angles at the centre of a cell.
  static HalfAngles angles_of(std::size_t half, std::size_t difference, std::size_t azimuth);

 private:
  MerlTable() = default;
  const Rgb& cell(std::size_t half, std::size_t difference, std::size_t azimuth) const {
    return cells_[azimuth + AzimuthCount * (difference + DifferenceCount * half)];
  }
  const Rgb& nearest_cell(const HalfAngles& angles) const;

  std::vector<Rgb> cells_;  ///< in 1/sr; a negative channel is invalid
};

}  // namespace reflectance
