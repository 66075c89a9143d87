// Several processes render parts of one image, which are merged to the image that one process would render.
#pragma once

#include <limits>
#include <vector>

#include "renderer/transport/film.h"

namespace transport {

/// A part of an image's samples. Ranges begin at `first` and stop before `end`.
struct ImagePart {
  static constexpr int All = std::numeric_limits<int>::max();

  int first_sample = 0;  ///< of each pixel
  int end_sample = All;
  int first_tile = 0;  ///< in the order of Film
  int end_tile = All;
  /// These samples are divided into `count` parts of nearly equal size, of which this is number `index`, from
  /// 0.
  int index = 0;
  int count = 1;

  bool operator==(const ImagePart&) const = default;
};

/// The numbers of the samples of a tile, by half: those from `first` up to but not including `end`.
struct TileSamples {
  FilmTile::Counts first = {};
  FilmTile::Counts end = {};
};

/// Returns the samples that a part has of each tile of an image with these sample counts, of which all parts
/// have those up to `done` already. If there are more parts than samples per pixel, parts have no samples of
/// some tiles.
std::vector<TileSamples> samples_of(const ImagePart& part, const std::vector<FilmTile::Counts>& counts,
                                    const FilmTile::Counts& done = {});

/// Returns whether a part has the pilot of a tile, see AdaptiveSampling: one process renders the pilot of a
/// tile.
bool has_pilot_of(const ImagePart& part, int tile);

}  // namespace transport
