// Surfaces of a scene are compared with what a format makes of them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "converters/format.h"
#include "grf/scene.h"

namespace convert {

/// The angles of the view from the normal at which albedos are compared, in degrees.
inline constexpr std::array<double, 4> ComparedDegrees = {0, 30, 60, 80};

/// A surface and what a format makes of it.
struct SurfaceComparison {
  std::string original;                                              ///< its BRDF and colour, as text
  std::string returned;                                              ///< those that come back
  std::size_t faces = 0;                                             ///< of all instances
  std::array<double, ComparedDegrees.size()> albedos = {};           ///< mean of the channels
  std::array<double, ComparedDegrees.size()> returned_albedos = {};  ///< likewise
  /// The mean of |f' - f| cos over the light's directions and these views, as a fraction of that of f cos;
  /// the delta parts count with their weights. Empty for a black original.
  std::optional<double> lobe_error;

  /// Returns the largest difference of the albedos.
  double albedo_change() const;
};

/// The surfaces that reflect, with those of most faces first, and the scene as the format has it.
struct ComparedScene {
  std::vector<SurfaceComparison> surfaces;
  std::size_t surfaces_left_out = 0;  ///< those of fewest faces beyond the most that are compared
  std::optional<grf::Scene> mapped;   ///< with the returned BRDFs, if the format is not read
};

/// Compares the surfaces of a scene without includes, whose file names are absolute, in a format that is
/// written. `folder` gets files that the mapped scene names. Nothing after an error.
std::optional<ComparedScene> compare_surfaces(const grf::Scene& scene, const Format& format,
                                              const std::string& folder, grf::Diagnostics& diagnostics);

}  // namespace convert
