#include "renderer/transport/tile_queue.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace transport {
namespace {

/// About 4,000 paths per tile: milliseconds, compared with which taking work costs nothing.
constexpr int LongestPass = 16;
/// The remaining work, in items per thread, at which items start to get shorter.
constexpr int ItemsAtTheEnd = 4;

std::int64_t sum(const FilmTile::Counts& counts) { return std::int64_t{counts[0]} + counts[1]; }

/// The counts of a tile once it has what is wanted: never fewer than it has.
FilmTile::Counts after(const FilmTile::Counts& present, const FilmTile::Counts& wanted) {
  return {std::max(present[0], wanted[0]), std::max(present[1], wanted[1])};
}

/// Counts between two states of a tile, for this many samples, with both halves about equally far; if the
/// halves end even, the first has the odd sample.
FilmTile::Counts part_of_the_way(const FilmTile::Counts& from, const FilmTile::Counts& to,
                                 std::int64_t samples) {
  const std::int64_t all = sum(to);
  const std::int64_t even = (2 * samples * to[0] + all) / (2 * all);
  const std::int64_t first = std::clamp<std::int64_t>(even, std::max<std::int64_t>(from[0], samples - to[1]),
                                                      std::min<std::int64_t>(to[0], samples - from[1]));
  return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(samples - first)};
}

}  // namespace

std::vector<int> tiles_from_the_centre(const Film& film) {
  struct Place {
    int ring;
    double angle;
    int tile;
  };
  std::vector<Place> places;
  places.reserve(static_cast<std::size_t>(film.tile_count()));
  for (int tile = 0; tile < film.tile_count(); ++tile) {
    const int x = 2 * (tile % film.tiles_across()) - (film.tiles_across() - 1);
    const int y = 2 * (tile / film.tiles_across()) - (film.tiles_down() - 1);
    places.push_back({std::max(std::abs(x), std::abs(y)), std::atan2(y, x), tile});
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return std::tie(a.ring, a.angle, a.tile) < std::tie(b.ring, b.angle, b.tile);
  });
  std::vector<int> tiles;
  tiles.reserve(places.size());
  for (const Place& place : places) tiles.push_back(place.tile);
  return tiles;
}

TileQueue::TileQueue(const Film& film, std::vector<FilmTile::Counts> wanted, int threads, ItemSize item_size)
    : wanted_(std::move(wanted)),
      threads_(threads),
      item_size_(item_size),
      tile_of_rank_(tiles_from_the_centre(film)),
      rank_of_tile_(tile_of_rank_.size()) {
  for (int rank = 0; rank < film.tile_count(); ++rank) {
    const int tile = tile_of_rank_[static_cast<std::size_t>(rank)];
    rank_of_tile_[static_cast<std::size_t>(tile)] = rank;
    if (push(film.counts_of(tile), tile)) ++unfinished_;
  }
}

/// Queues a tile, unless it has all its samples.
bool TileQueue::push(const FilmTile::Counts& present, int tile) {
  const auto index = static_cast<std::size_t>(tile);
  const std::int64_t missing = sum(after(present, wanted_[index])) - sum(present);
  if (missing == 0) return false;
  const double done = static_cast<double>(sum(present)) / static_cast<double>(sum(wanted_[index]));
  waiting_.push({done, rank_of_tile_[index], present});
  remaining_ += missing;
  return true;
}

bool TileQueue::is_finished() {
  const std::lock_guard lock(mutex_);
  return unfinished_ == 0;
}

// Even lengths keep the two scramblings of a pixel balanced.
std::int64_t TileQueue::length_of_next(std::int64_t present, std::int64_t wanted) const {
  if (item_size_ == ItemSize::Whole) return wanted - present;
  const std::int64_t growing = present < 2 ? 2 : std::min<std::int64_t>(present, LongestPass);
  const std::int64_t share = remaining_ / (ItemsAtTheEnd * threads_);
  return std::min(std::clamp<std::int64_t>(share, 1, growing), wanted - present);
}

std::optional<TileWork> TileQueue::take() {
  const std::lock_guard lock(mutex_);
  if (waiting_.empty()) return std::nullopt;
  const Waiting next = waiting_.top();
  waiting_.pop();
  const int tile = tile_of_rank_[static_cast<std::size_t>(next.rank)];
  const FilmTile::Counts end = after(next.present, wanted_[static_cast<std::size_t>(tile)]);
  const std::int64_t length = length_of_next(sum(next.present), sum(end));
  remaining_ -= sum(end) - sum(next.present);
  return TileWork{tile, next.present, part_of_the_way(next.present, end, sum(next.present) + length)};
}

void TileQueue::done(const TileWork& work) {
  const std::lock_guard lock(mutex_);
  if (!push(work.last, work.tile)) --unfinished_;
}

}  // namespace transport
