#pragma once

#include <optional>
#include <vector>

#include "renderer/transport/render.h"

namespace transport {

/// Paths that end after fewer bounces than asked for: what that leaves out, and what it saves.
///
/// The light of the last bounce is multiplied by a factor that stands for all later bounces. Light after many
/// bounces is distributed like the dominant eigenfunction of the light transport operator, whose powers it
/// consists of: so later bounces look more and more like the last one.
struct Truncation {
  int depth = 0;  ///< the maximum number of bounces
  Rgb last_bounce_factor = Rgb(1);
  /// sqrt(relMSE) of the expected image against that of all bounces.
  ErrorEstimate bias;
  double rays = 1;      ///< of a path, relative to those of all bounces
  double variance = 1;  ///< of a pixel, relative likewise

  /// Returns the rays that a render takes until a target error, relative to those of all bounces; infinite if
  /// the bias is not negligible. The noise may be less than the target, as the bias is part of the error.
  double cost(double target_error) const;
};

/// Measures each number of bounces from 1 to less than the settings ask for, up to 31, in this order, at some
/// pixels of the image: a pilot. `Path` only; else empty. The result depends on the settings only, not on the
/// number of threads.
///
/// Let T be a pixel's light of later bounces, and L that of the last one. The factor 1 + f minimises the sum
/// over pixels of the squared bias (T - f L)^2, relative as in relMSE. Products are taken of independent
/// estimates of the pixel, so that noise has no part in their means. The interval is Student's over pixels.
std::vector<Truncation> truncations_of(const CompiledScene& scene, const RenderSettings& settings);

/// Returns the one of least cost for a target error; empty if none saves more than the pilot's uncertainty.
std::optional<Truncation> truncation_for(const std::vector<Truncation>& truncations, double target_error);

/// Truncates the paths of a render.
void follow(const Truncation& truncation, RenderSettings& settings);

}  // namespace transport
