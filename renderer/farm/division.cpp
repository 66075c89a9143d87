#include "renderer/farm/division.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "renderer/transport/film.h"

namespace farm {

using transport::TileSamples;

namespace {

constexpr std::size_t TilePixels = std::size_t{transport::Film::TileSize} * transport::Film::TileSize;
constexpr std::size_t TileBytes = TilePixels * sizeof(transport::FilmTile::PixelSums) + 64;
constexpr std::size_t EmptyTileBytes = 8;
constexpr std::size_t HeaderBytes = 512;

std::uint64_t count_of(const TileSamples& samples) {
  return std::uint64_t{samples.end[0] - samples.first[0]} + (samples.end[1] - samples.first[1]);
}

/// Divides the samples of a tile into ranges of nearly equal size, in which the halves take turns.
std::vector<TileSamples> ranges_of(const TileSamples& samples, std::uint64_t ranges) {
  const std::uint64_t all = count_of(samples);
  const std::uint64_t of_first = samples.end[0] - samples.first[0];
  std::vector<TileSamples> divided(static_cast<std::size_t>(ranges), samples);
  for (std::uint64_t i = 1; i < ranges; ++i) {
    const std::uint64_t done = all / ranges * i + all % ranges * i / ranges;
    const std::uint64_t done_of_first = (of_first * done + all - 1) / all;
    const transport::FilmTile::Counts middle = {
        samples.first[0] + static_cast<std::uint32_t>(done_of_first),
        samples.first[1] + static_cast<std::uint32_t>(done - done_of_first)};
    divided[static_cast<std::size_t>(i - 1)].end = middle;
    divided[static_cast<std::size_t>(i)].first = middle;
  }
  return divided;
}

}  // namespace

std::size_t tile_bytes(int tiles) {
  return HeaderBytes + TileBytes + EmptyTileBytes * static_cast<std::size_t>(tiles);
}

std::vector<Task> divide(const Stage& stage, int first_number, double seconds_per_sample,
                         const TaskLimits& limits) {
  const auto tiles = static_cast<int>(stage.samples.size());
  const std::size_t empty = tile_bytes(tiles) - TileBytes;
  const std::size_t room = limits.bytes > empty ? (limits.bytes - empty) / TileBytes : 0;
  std::vector<Task> tasks;
  const auto begin_task = [&](int tile) {
    tasks.push_back({first_number + static_cast<int>(tasks.size()), tile, {}, stage.is_pilot});
  };
  double seconds = 0;
  bool has_room = false;
  for (int tile = 0; tile < tiles; ++tile) {
    const TileSamples& samples = stage.samples[static_cast<std::size_t>(tile)];
    const std::uint64_t count = count_of(samples);
    const double own = seconds_per_sample * TilePixels * static_cast<double>(count);
    const bool is_divided = own > limits.seconds && count > 1 && !stage.is_pilot;
    if (is_divided) {
      const double ranges = std::min(std::ceil(own / limits.seconds), static_cast<double>(count));
      for (const TileSamples& range : ranges_of(samples, static_cast<std::uint64_t>(ranges))) {
        begin_task(tile);
        tasks.back().samples = {range};
      }
    } else if (count > 0) {
      has_room = has_room && seconds + own <= limits.seconds && tasks.back().samples.size() < room;
      if (!has_room) {
        begin_task(tile);
        seconds = 0;
      }
      seconds += own;
      tasks.back().samples.push_back(samples);
    }
    has_room = !is_divided && count > 0;
  }
  return tasks;
}

}  // namespace farm
