#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "renderer/transport/film.h"

namespace transport {

/// A range of samples of a tile: for each half, those from `first` up to but not including `last`.
struct TileWork {
  int tile = 0;
  FilmTile::Counts first = {};
  FilmTile::Counts last = {};
};

/// Work queue of tiles, until all have their wanted samples. The tile with the smallest completed fraction
/// comes first, and of those the nearest to the image's centre; no pass ends in a barrier. The first passes
/// over the image are short, so that a preview appears soon, and so are the last work items, so that all
/// workers finish at about the same time. How work is split does not affect the image.
class TileQueue {
 public:
  enum class ItemSize {
    Short,
    Whole,  ///< one work item per tile
  };

  /// The film has the samples so far; `wanted` are the target counts of each tile.
  TileQueue(const Film& film, std::vector<FilmTile::Counts> wanted, int threads,
            ItemSize item_size = ItemSize::Short);

  /// Returns work on a tile that no other worker has; empty if there is none. The caller reports it by
  /// `done`.
  std::optional<TileWork> take();
  void done(const TileWork& work);

  /// Whether all tiles have their wanted samples.
  bool is_finished();

 private:
  struct Waiting {
    double done = 0;  ///< fraction of the wanted samples that are done
    int rank = 0;     ///< in order of distance from the centre
    FilmTile::Counts present = {};
    bool operator>(const Waiting& other) const {
      return std::pair(done, rank) > std::pair(other.done, other.rank);
    }
  };

  bool push(const FilmTile::Counts& present, int tile);
  std::int64_t length_of_next(std::int64_t present, std::int64_t wanted) const;

  const std::vector<FilmTile::Counts> wanted_;
  const int threads_;
  const ItemSize item_size_;
  std::vector<int> tile_of_rank_;
  std::vector<int> rank_of_tile_;
  std::mutex mutex_;            ///< guards the members below
  std::size_t unfinished_ = 0;  ///< number of tiles
  std::int64_t remaining_ = 0;  ///< samples in tiles that nobody has taken
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
};

/// Returns all tiles of a film, ring by ring from its centre: consecutive ones are neighbours.
std::vector<int> tiles_from_the_centre(const Film& film);

}  // namespace transport
