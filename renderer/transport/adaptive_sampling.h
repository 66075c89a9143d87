#pragma once

#include <vector>

#include "renderer/transport/film.h"

namespace transport {

/// Returns the sample counts of the halves for uniform sampling; the first half has the odd one.
FilmTile::Counts uniform_counts(int samples);

/// Adaptive sampling: distributes samples over the tiles to minimise the relMSE of an image with a given mean
/// number of samples per pixel. Counts are proportional to the relative standard deviation of a sample, which
/// pilot samples estimate; at least `MinFraction` of the mean, because the pilot may miss rare events.
///
/// The result is unbiased. A mean of samples whose number depends on these samples is biased, as a few dark
/// ones would be thought enough (Kirk and Arvo 1991, "Unbiased sampling techniques for image synthesis").
/// Here the counts of one half depend only on the pilot of the other half: given that, a half's count is a
/// fixed number and its mean unbiased. The image is (a + b) / 2 of the halves' means, whatever their counts.
/// The pilot has the same number of samples everywhere, and proportions are decided once: a second decision
/// would see samples whose number the half itself had influenced.
class AdaptiveSampling {
 public:
  /// Pilot samples per pixel, of both halves together. Within a half, the first ones are compared with the
  /// others.
  static constexpr int PilotSamples = 32;
  static constexpr double MinFraction = 0.25;

  /// The film must hold the pilot's spreads. Tiles without samples get none, as in a probe of the image.
  explicit AdaptiveSampling(const Film& film);

  /// Sample counts per tile for a mean of at most `samples` per pixel, which must be at least PilotSamples.
  /// The counts of each tile grow monotonically with `samples`.
  std::vector<FilmTile::Counts> counts(int samples) const;

 private:
  std::vector<double> pixels_;                                  ///< per tile
  std::array<std::vector<double>, Film::Scramblings> weights_;  ///< per half and tile
};

}  // namespace transport
