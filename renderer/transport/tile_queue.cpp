#include "renderer/transport/tile_queue.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace transport {
namespace {

/// About 4,000 paths a tile: milliseconds, against which taking work costs nothing.
constexpr int LongestPass = 16;
/// Work left when pieces start to get shorter, for each thread, in pieces.
constexpr int PiecesAtTheEnd = 4;

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

TileQueue::TileQueue(const Film& film, int samples, int threads)
    : samples_(samples),
      threads_(threads),
      tile_of_rank_(tiles_from_the_centre(film)),
      rank_of_tile_(tile_of_rank_.size()) {
  std::vector<Waiting> waiting;
  waiting.reserve(tile_of_rank_.size());
  for (int rank = 0; rank < film.tile_count(); ++rank) {
    const int tile = tile_of_rank_[static_cast<std::size_t>(rank)];
    rank_of_tile_[static_cast<std::size_t>(tile)] = rank;
    const int present = static_cast<int>(film.sample_count_of(tile));
    if (present >= samples) continue;
    waiting.push_back({present, rank});
    remaining_ += samples - present;
  }
  unfinished_ = waiting.size();
  waiting_ = decltype(waiting_)({}, std::move(waiting));
}

bool TileQueue::is_finished() {
  const std::lock_guard lock(mutex_);
  return unfinished_ == 0;
}

// Even lengths keep the two scramblings of a pixel even.
int TileQueue::length_of_next(int samples) const {
  const int growing = samples < 2 ? 2 : std::min(samples, LongestPass);
  const std::int64_t share = remaining_ / (PiecesAtTheEnd * threads_);
  const int length = static_cast<int>(std::clamp<std::int64_t>(share, 1, growing));
  return std::min(length, samples_ - samples);
}

std::optional<TileWork> TileQueue::take() {
  const std::lock_guard lock(mutex_);
  if (waiting_.empty()) return std::nullopt;
  const Waiting next = waiting_.top();
  waiting_.pop();
  const int length = length_of_next(next.samples);
  remaining_ -= samples_ - next.samples;
  return TileWork{tile_of_rank_[static_cast<std::size_t>(next.rank)], next.samples, next.samples + length};
}

void TileQueue::done(const TileWork& work) {
  const std::lock_guard lock(mutex_);
  if (work.last >= samples_) {
    --unfinished_;
    return;
  }
  waiting_.push({work.last, rank_of_tile_[static_cast<std::size_t>(work.tile)]});
  remaining_ += samples_ - work.last;
}

}  // namespace transport
