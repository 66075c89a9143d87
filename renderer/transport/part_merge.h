// Parts of an image are merged to the image that one process would render.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/transport/part_file.h"

namespace transport {

/// The samples of a tile, by half.
using TileIntervals = std::array<SampleIntervals, FilmTile::Scramblings>;

/// Adds up parts of one image.
class PartMerge {
 public:
  /// Adds a part that was read from this file. A part that was added before is left out, if its values are
  /// the same. Errors name both files: another image, the same samples with other values, and parts of which
  /// only some samples are the same.
  bool add(SamplePart part, const std::string& path, grf::Diagnostics& diagnostics);

  /// The sum of the parts; there must be one.
  const SamplePart& sum() const { return sum_; }
  /// The image of the sum; tiles without samples are black.
  Film film() const;
  /// Whether all tiles have the pilot of an adaptive image.
  bool has_whole_pilot() const;

  /// Returns parts that together have the samples that lack; while the pilot of an adaptive image is
  /// incomplete, parts of the pilot. They are those of a division of which there are other parts, and ranges.
  std::vector<ImagePart> missing() const;

 private:
  struct Origin {
    std::string path;
    std::map<std::size_t, TileIntervals> samples;  ///< by tile, of those that have any
  };

  bool fits(const SamplePart& part, const std::string& path, grf::Diagnostics& diagnostics) const;
  bool is_repeated(const SamplePart& part, const Origin& origin, grf::Diagnostics& diagnostics) const;
  void add_samples(const SamplePart& part);
  bool lacks_pilot() const;
  std::vector<FilmTile::Counts> counts_wanted() const;
  std::vector<TileIntervals> samples_in(const RenderedPart& rendered,
                                        const std::vector<FilmTile::Counts>& counts) const;

  SamplePart sum_;
  std::vector<Origin> origins_;
};

}  // namespace transport
