#include "renderer/farm/division.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "renderer/transport/film.h"

namespace farm {

using transport::Film;
using transport::ImagePart;

namespace {

constexpr int Side = Film::TileSize;
constexpr std::size_t TileBytes = Side * Side * sizeof(transport::FilmTile::PixelSums) + 64;
constexpr std::size_t EmptyTileBytes = 8;
constexpr std::size_t HeaderBytes = 512;

}  // namespace

std::size_t tile_bytes(int tiles) {
  return HeaderBytes + TileBytes + EmptyTileBytes * static_cast<std::size_t>(tiles);
}

std::vector<ImagePart> divide(int width, int height, int samples, double seconds_per_sample,
                              const TaskLimits& limits) {
  constexpr double TilePixels = Side * Side;
  const int tiles = (width + Side - 1) / Side * ((height + Side - 1) / Side);
  const double seconds_of_tile = seconds_per_sample * TilePixels * samples;
  std::vector<ImagePart> tasks;
  if (seconds_of_tile > limits.seconds) {
    const int ranges =
        static_cast<int>(std::min<double>(samples, std::ceil(seconds_of_tile / limits.seconds)));
    const auto beginning = [&](int range) {
      return static_cast<int>(std::int64_t{samples} * range / ranges);
    };
    for (int tile = 0; tile < tiles; ++tile) {
      for (int range = 0; range < ranges; ++range)
        tasks.push_back({beginning(range), beginning(range + 1), tile, tile + 1});
    }
    return tasks;
  }
  const std::size_t empty = tile_bytes(tiles) - TileBytes;
  const std::size_t room = limits.bytes > empty ? (limits.bytes - empty) / TileBytes : 0;
  const double most = std::min({limits.seconds / seconds_of_tile, double(room), double(tiles)});
  const int step = std::max(1, static_cast<int>(most));
  for (int tile = 0; tile < tiles; tile += step) {
    tasks.push_back({0, samples, tile, std::min(tiles, tile + step)});
  }
  return tasks;
}

}  // namespace farm
