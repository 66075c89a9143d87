#include "renderer/transport/image_part.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "renderer/transport/adaptive_sampling.h"

namespace transport {
namespace {

/// Returns where part `index` of a half's samples begins, of which there are this many. Where the parts are
/// not equal, the longer ones differ from tile to tile, so that all parts have equally many samples of the
/// image: their beginnings are rounded by the additive recurrence of the golden ratio.
std::uint32_t beginning_of(std::uint32_t index, std::uint32_t parts, std::uint32_t samples,
                           std::uint64_t half) {
  constexpr std::uint64_t GoldenRatio = 0x9E3779B97F4A7C15;  // its fraction, times 2^64
  constexpr std::uint64_t One = std::uint64_t{1} << 32;
  const std::uint64_t rounding = (half * GoldenRatio) >> 32;
  const std::uint64_t all = std::uint64_t{samples} * index;
  // The quotient and the remainder apart, so that nothing exceeds 64 bits.
  return static_cast<std::uint32_t>(all / parts + (all % parts * One / parts + rounding) / One);
}

}  // namespace

std::vector<TileSamples> samples_of(const ImagePart& part, const std::vector<FilmTile::Counts>& counts,
                                    const FilmTile::Counts& done) {
  const FilmTile::Counts first = uniform_counts(part.first_sample);
  const FilmTile::Counts end = uniform_counts(part.end_sample);
  const auto index = static_cast<std::uint32_t>(part.index);
  const auto parts = static_cast<std::uint32_t>(part.count);
  std::vector<TileSamples> samples(counts.size());
  for (std::size_t tile = 0; tile < counts.size(); ++tile) {
    if (std::cmp_less(tile, part.first_tile) || std::cmp_greater_equal(tile, part.end_tile)) continue;
    for (std::size_t half = 0; half < first.size(); ++half) {
      const std::uint32_t from = std::max(first[half], done[half]);
      const std::uint32_t to = std::max(from, std::min(end[half], counts[tile][half]));
      const std::uint64_t place = first.size() * tile + half;
      samples[tile].first[half] = from + beginning_of(index, parts, to - from, place);
      samples[tile].end[half] = from + beginning_of(index + 1, parts, to - from, place);
    }
  }
  return samples;
}

bool has_pilot_of(const ImagePart& part, int tile) {
  return tile >= part.first_tile && tile < part.end_tile && tile % part.count == part.index;
}

}  // namespace transport
