// Observations are values of a BRDF for pairs of directions: what a fit is made to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/math.h"
#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/measurements/measurement.h"

namespace fit {

using grf::Vec3d;

using Observation = reflectance::Measurement;

/// A set of observations, and what is known of all of them.
struct Observations {
  std::string description;  ///< where they are from and how they were chosen, a sentence
  std::vector<Observation> list;
  bool is_isotropic = true;  ///< turning both directions about the normal is taken to change nothing
  bool is_grey = true;       ///< the channels are equal
};

/// Evaluates a BRDF, in double and on several threads, for the directions of observations.
void evaluate(const reflectance::Brdf& brdf, std::span<const Observation> observations,
              std::vector<Vec3d>& values);

/// Returns the mean of f cos(theta_v) of data, over all channels.
double mean_of(const std::vector<Observation>& list);

/// Returns the observations that can be used, or nothing after an error: there are none, or all are 0. Those
/// that are not finite or negative, or have a direction at or below the horizon, are left out with a warning
/// that counts them and points to the first one's line. Warns of values of which all are from one view.
std::optional<Observations> usable(Observations observations, const std::string& path,
                                   grf::Diagnostics& diagnostics);

/// Samples a BRDF at `count` pairs of directions, which are the same each time. Their half-angle coordinates
/// are a Sobol sequence with the density of MERL's cells: theta_h = 90 degrees s^2, and theta_d and phi_d
/// uniform; anisotropic BRDFs are also turned about the normal. Directions are up to 88 degrees from the
/// normal, and for measured data up to 80. The cells of a MERL table itself are taken if the BRDF is
/// one (see `cells_of`). Warns of a delta part, which no values show.
Observations sampled(const reflectance::Brdf& brdf, std::size_t count, grf::Diagnostics& diagnostics);

/// Takes cells of a MERL table, all or `count` of them: one at random, the same each time, of as many runs of
/// cells. Cells over 80 degrees, which were extrapolated, and cells without a value are left out.
Observations cells_of(const reflectance::MerlTable& table, std::size_t count);

/// Reads observations from a CSV file (see `reflectance::parse_csv`); returns nothing after an error.
std::optional<Observations> read_csv(const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace fit
