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

/// Some samples of a tile: of each half those from `first` on, before `last`.
struct TileWork {
  int tile = 0;
  FilmTile::Counts first = {};
  FilmTile::Counts last = {};
};

/// What the workers do next, until all tiles have the samples that are wanted of them. The tile that has the
/// smallest part of its own comes first, and of those the nearest to the image's centre; there is no end of a
/// pass to wait for. The first passes over the image are short, so that there is soon something to look at,
/// and so are the last pieces of work, so that all workers end at about the same time. How the work is cut
/// does not show in the image.
class TileQueue {
 public:
  enum class Pieces {
    Short,
    Whole,  ///< a tile is one piece of work
  };

  /// The film says what there is already; `wanted` is for each of its tiles.
  TileQueue(const Film& film, std::vector<FilmTile::Counts> wanted, int threads,
            Pieces pieces = Pieces::Short);

  /// A tile that no other worker has; nothing once there is none. Whoever took it says when it is done.
  std::optional<TileWork> take();
  void done(const TileWork& work);

  /// Whether all tiles have their samples.
  bool is_finished();

 private:
  struct Waiting {
    double done = 0;  ///< the part of what is wanted that there is
    int rank = 0;     ///< in the order from the centre outwards
    FilmTile::Counts present = {};
    bool operator>(const Waiting& other) const {
      return std::pair(done, rank) > std::pair(other.done, other.rank);
    }
  };

  bool push(const FilmTile::Counts& present, int tile);
  std::int64_t length_of_next(std::int64_t present, std::int64_t wanted) const;

  const std::vector<FilmTile::Counts> wanted_;
  const int threads_;
  const Pieces pieces_;
  std::vector<int> tile_of_rank_;
  std::vector<int> rank_of_tile_;
  std::mutex mutex_;            ///< of what follows
  std::size_t unfinished_ = 0;  ///< tiles
  std::int64_t remaining_ = 0;  ///< samples of tiles that nobody has taken
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
};

/// All tiles of a film, ring by ring from its centre: neighbours follow each other.
std::vector<int> tiles_from_the_centre(const Film& film);

}  // namespace transport
