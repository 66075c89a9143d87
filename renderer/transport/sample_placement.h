#pragma once

#include <vector>

#include "renderer/transport/film.h"

namespace transport {

/// How many samples each half has if all pixels have as many; the first half has the odd one.
FilmTile::Counts uniform_counts(int samples);

/// Adaptive sampling: how many samples the pixels of each tile get, for the least relMSE of the image at so
/// many samples a pixel in the mean. That is in proportion to the standard deviation of a sample, relative to
/// the pixel's radiance, of which a pilot of samples tells; at least `LeastShare` of the mean, because what
/// is rare may have missed the pilot.
///
/// Nothing of this is biased. A mean of samples whose number follows from these samples is biased, as a few
/// dark ones would be thought enough (Kirk and Arvo 1991, "Unbiased sampling techniques for image
/// synthesis"). Here the counts of one half follow from the pilot of the other half, and from nothing else:
/// given that, a half's count is a fixed number and its mean unbiased. The image is (a + b) / 2 of the
/// halves' means, whatever their counts. The pilot has the same number of samples everywhere, and proportions
/// are never decided anew: a second decision would see samples whose number the half itself had a part in.
class SamplePlacement {
 public:
  /// A pixel's, of both halves together. The first half of them are set against the second one.
  static constexpr int PilotSamples = 32;
  static constexpr double LeastShare = 0.25;

  /// The film must hold the pilot's spreads.
  explicit SamplePlacement(const Film& film);

  /// Of each tile, for a mean of no more than `samples` a pixel, which are at least PilotSamples. For more
  /// samples, no tile has less.
  std::vector<FilmTile::Counts> counts(int samples) const;

 private:
  std::vector<double> pixels_;                                  ///< of each tile
  std::array<std::vector<double>, Film::Scramblings> weights_;  ///< of each half's tiles
};

}  // namespace transport
