#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/reflectance/model.h"
#include "renderer/reflectance/rgl_tables.h"

namespace reflectance {

/// A measured BRDF of the RGL material data base, from its file (Dupuy and Jakob 2018, "An Adaptive
/// Parameterization for Efficient Material Acquisition and Rendering"). The tables' view directions are u.
/// Directions are unit vectors; those at or below the horizon give 0.
class RglData {
 public:
  /// Loads a file, or returns nothing after an error: missing file, or not of this format.
  static std::shared_ptr<const RglData> load(const std::string& path, grf::Diagnostics& diagnostics,
                                             const grf::SourceLocation& asked_for_at = {});

  explicit RglData(RglTables tables);

  /// Evaluates f(u, v) in 1/sr as linear sRGB.
  Imath::V3d evaluate(const Imath::V3d& u, const Imath::V3d& v) const;

  /// Returns true if a channel of the table is negative there, which `evaluate` takes as 0.
  bool is_negative(const Imath::V3d& u, const Imath::V3d& v) const;

  /// Returns the wavelengths that the file has, in nanometres and ascending; empty for an RGB file.
  const std::vector<float>& wavelengths() const { return tables_.wavelengths; }

  /// Evaluates f(u, v) in 1/sr at each of the wavelengths.
  std::vector<double> spectrum(const Imath::V3d& u, const Imath::V3d& v) const;

  /// Samples a direction from the file's own tables; it can be below the horizon.
  Imath::V3d direction(const Imath::V3d& u, const Imath::V2d& xi) const;

  /// Returns the pdf of `direction` per solid angle of v.
  double pdf(const Imath::V3d& u, const Imath::V3d& v) const;

  /// Evaluates f(u, v) and the pdf together, which share most of their work.
  Reflection reflect(const Imath::V3d& u, const Imath::V3d& v) const;

  /// Estimates the mean albedo of the channels, at most 1, from a table over the angle of u.
  float albedo(const Vec3f& u) const;

  /// Returns what the file says of itself.
  bool is_isotropic() const { return tables_.range == AzimuthRange::Isotropic; }
  const std::string& description() const { return tables_.description; }

 private:
  static constexpr std::size_t AlbedoCount = 17;  ///< over cos(theta_u) from 0 to 1

  struct View;
  struct Place;
  View view_of(const Imath::V3d& u) const;
  Place place_of(const View& view, const Imath::V3d& v) const;
  double sampled_pdf(const Place& place, const View& view) const;
  Imath::V3d rgb_at(const Place& place, const View& view) const;
  float estimated_albedo(double cosine) const;

  RglTables tables_;
  std::array<float, AlbedoCount> albedos_ = {};
};

}  // namespace reflectance
