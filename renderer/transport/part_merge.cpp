#include "renderer/transport/part_merge.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "renderer/transport/adaptive_sampling.h"

namespace transport {
namespace {

constexpr auto HalfCount = static_cast<std::size_t>(FilmTile::Scramblings);
constexpr int PilotSamples = AdaptiveSampling::PilotSamples;

bool overlap(const TileIntervals& a, const TileIntervals& b) {
  return overlap(a[0], b[0]) || overlap(a[1], b[1]);
}

bool is_empty(const TileIntervals& samples) { return samples[0].empty() && samples[1].empty(); }

/// Returns the samples of a tile up to these counts.
TileIntervals samples_up_to(const FilmTile::Counts& counts) {
  TileIntervals samples;
  for (std::size_t half = 0; half < HalfCount; ++half) {
    if (counts[half] > 0) samples[half] = {{0, counts[half]}};
  }
  return samples;
}

/// Returns ranges of the samples of pixels, of which those of the halves take turns.
SampleIntervals ranges_of(const TileIntervals& samples) {
  std::vector<std::uint32_t> numbers;
  for (std::size_t half = 0; half < HalfCount; ++half) {
    for (const SampleInterval& interval : samples[half]) {
      for (std::uint32_t i = interval.first; i < interval.end; ++i) {
        numbers.push_back(i * static_cast<std::uint32_t>(HalfCount) + static_cast<std::uint32_t>(half));
      }
    }
  }
  std::ranges::sort(numbers);
  SampleIntervals ranges;
  for (const std::uint32_t number : numbers) {
    if (ranges.empty() || ranges.back().end != number) ranges.push_back({number, number});
    ranges.back().end = number + 1;
  }
  return ranges;
}

/// Returns parts that have these samples of each tile.
std::vector<ImagePart> parts_of(const std::vector<TileIntervals>& samples) {
  std::vector<ImagePart> parts;
  for (std::size_t first = 0, end = 0; first < samples.size(); first = end) {
    while (end < samples.size() && samples[end] == samples[first]) ++end;
    for (const SampleInterval& range : ranges_of(samples[first])) {
      parts.push_back({static_cast<int>(range.first), static_cast<int>(range.end), static_cast<int>(first),
                       static_cast<int>(end)});
    }
  }
  return parts;
}

}  // namespace

bool PartMerge::fits(const SamplePart& part, const std::string& path, grf::Diagnostics& diagnostics) const {
  const std::string& first = origins_.front().path;
  const auto refuse = [&](std::string_view what) {
    diagnostics.error(grf::whole_file(path),
                      fmt::format("it is no part of the image that '{}' is of: {}", first, what));
    return false;
  };
  if (part.fingerprint.files != sum_.fingerprint.files) return refuse("the scene has other contents");
  if (part.width != sum_.width || part.height != sum_.height || part.is_adaptive != sum_.is_adaptive ||
      part.fingerprint.options != sum_.fingerprint.options) {
    return refuse("it has other options");
  }
  if (part.image_samples != sum_.image_samples) {
    return refuse(
        fmt::format("it has {} samples per pixel, and that one {}", part.image_samples, sum_.image_samples));
  }
  if (part.fingerprint.program != sum_.fingerprint.program) return refuse("it is by another build of bpt");
  return true;
}

bool PartMerge::add(SamplePart part, const std::string& path, grf::Diagnostics& diagnostics) {
  Origin origin{path, {}};
  for (std::size_t tile = 0; tile < part.tiles.size(); ++tile) {
    if (!part.tiles[tile].is_empty()) origin.samples[tile] = part.tiles[tile].samples;
  }
  if (origins_.empty()) {
    sum_ = std::move(part);
    origins_.push_back(std::move(origin));
    return true;
  }
  if (!fits(part, path, diagnostics)) return false;
  const bool is_new = std::ranges::equal(part.tiles, sum_.tiles, [](const PartTile& a, const PartTile& b) {
    return !overlap(a.samples, b.samples);
  });
  if (!is_new) return is_repeated(part, origin, diagnostics);
  add_samples(part);
  sum_.parts.insert(sum_.parts.end(), part.parts.begin(), part.parts.end());
  if (part.tiles.front().has_first_sample()) sum_.description = std::move(part.description);
  origins_.push_back(std::move(origin));
  return true;
}

/// Returns whether an earlier part has the samples of this one, of which some are not new, and the same
/// values.
bool PartMerge::is_repeated(const SamplePart& part, const Origin& origin,
                            grf::Diagnostics& diagnostics) const {
  const auto has_same = [&](const Origin& other) {
    return std::ranges::any_of(origin.samples, [&](const auto& own) {
      const auto same = other.samples.find(own.first);
      return same != other.samples.end() && overlap(own.second, same->second);
    });
  };
  const Origin& other = *std::ranges::find_if(origins_, has_same);
  const auto refuse = [&](std::string_view what) {
    diagnostics.error(grf::whole_file(origin.path),
                      fmt::format("it has samples of '{}', {}", other.path, what));
    return false;
  };
  if (origin.samples != other.samples) return refuse("but not all, or others besides");
  const auto earlier = read_part(other.path, diagnostics);
  if (!earlier) return false;
  const bool are_equal = std::ranges::equal(
      part.tiles, earlier->tiles,
      [](const PartTile& a, const PartTile& b) { return a.pixels == b.pixels && a.spreads == b.spreads; });
  return are_equal || refuse("with other values: one of them is wrong");
}

void PartMerge::add_samples(const SamplePart& part) {
  for (std::size_t i = 0; i < part.tiles.size(); ++i) {
    PartTile& to = sum_.tiles[i];
    const PartTile& from = part.tiles[i];
    if (from.is_empty()) continue;
    to.pixels.resize(from.pixels.size());
    for (std::size_t half = 0; half < HalfCount; ++half) {
      to.samples[half] = joined(to.samples[half], from.samples[half]);
      to.spreads[half] += from.spreads[half];  // one of them is 0
      for (std::size_t p = 0; p < from.pixels.size(); ++p) to.pixels[p][half] += from.pixels[p][half];
    }
  }
  sum_.totals.paths += part.totals.paths;
  sum_.totals.rays += part.totals.rays;
  sum_.totals.rejected += part.totals.rejected;
  sum_.totals.first_rejected = std::min(sum_.totals.first_rejected, part.totals.first_rejected);
  sum_.totals.seconds += part.totals.seconds;
  sum_.totals.sampling_seconds += part.totals.sampling_seconds;
}

Film PartMerge::film() const {
  Film film(static_cast<int>(sum_.width), static_cast<int>(sum_.height));
  FilmTile tile;
  for (int i = 0; i < film.tile_count(); ++i) {
    const PartTile& own = sum_.tiles[static_cast<std::size_t>(i)];
    if (own.is_empty()) continue;
    tile.bounds = film.bounds_of(i);
    for (std::size_t half = 0; half < HalfCount; ++half) tile.counts[half] = count_of(own.samples[half]);
    tile.spreads = own.spreads;
    tile.pixels = own.pixels;
    film.put_back(i, tile);
  }
  return film;
}

bool PartMerge::has_whole_pilot() const {
  const TileIntervals pilot = samples_up_to(uniform_counts(PilotSamples));
  return std::ranges::all_of(sum_.tiles, [&](const PartTile& tile) {
    return without(pilot[0], tile.samples[0]).empty() && without(pilot[1], tile.samples[1]).empty();
  });
}

/// Returns whether the image is adaptive, and its pilot incomplete.
bool PartMerge::lacks_pilot() const {
  return sum_.is_adaptive != 0 && std::cmp_greater(sum_.image_samples, PilotSamples) && !has_whole_pilot();
}

/// Returns the sample counts of each tile of the whole image, or of its pilot while that is incomplete.
std::vector<FilmTile::Counts> PartMerge::counts_wanted() const {
  const auto samples = static_cast<int>(sum_.image_samples);
  if (lacks_pilot()) return std::vector<FilmTile::Counts>(sum_.tiles.size(), uniform_counts(PilotSamples));
  if (sum_.is_adaptive != 0 && samples > PilotSamples) return AdaptiveSampling(film()).counts(samples);
  return std::vector<FilmTile::Counts>(sum_.tiles.size(), uniform_counts(samples));
}

/// Returns the samples of each tile that a part has, of an image or of its pilot.
std::vector<TileIntervals> PartMerge::samples_in(const RenderedPart& rendered,
                                                 const std::vector<FilmTile::Counts>& counts) const {
  std::vector<TileIntervals> result(counts.size());
  if (rendered.is_of_pilot != 0) {
    for (std::size_t tile = 0; tile < counts.size(); ++tile) {
      if (has_pilot_of(rendered.part, static_cast<int>(tile))) result[tile] = samples_up_to(counts[tile]);
    }
    return result;
  }
  const FilmTile::Counts done = sum_.is_adaptive != 0 ? uniform_counts(PilotSamples) : FilmTile::Counts();
  const std::vector<TileSamples> samples = samples_of(rendered.part, counts, done);
  for (std::size_t tile = 0; tile < counts.size(); ++tile) {
    for (std::size_t half = 0; half < HalfCount; ++half) {
      const SampleInterval own{samples[tile].first[half], samples[tile].end[half]};
      if (own.end > own.first) result[tile][half] = {own};
    }
  }
  return result;
}

std::vector<ImagePart> PartMerge::missing() const {
  const std::vector<FilmTile::Counts> counts = counts_wanted();
  std::vector<TileIntervals> lacking(counts.size());
  for (std::size_t tile = 0; tile < counts.size(); ++tile) {
    const TileIntervals all = samples_up_to(counts[tile]);
    for (std::size_t half = 0; half < HalfCount; ++half) {
      lacking[tile][half] = without(all[half], sum_.tiles[tile].samples[half]);
    }
  }
  std::vector<ImagePart> missing;
  const auto take = [&](const RenderedPart& candidate) {
    const std::vector<TileIntervals> own = samples_in(candidate, counts);
    if (std::ranges::equal(own, lacking, [](const auto& a, const auto& b) { return !overlap(a, b); })) return;
    missing.push_back(candidate.part);
    for (std::size_t tile = 0; tile < counts.size(); ++tile) {
      for (std::size_t half = 0; half < HalfCount; ++half) {
        lacking[tile][half] = without(lacking[tile][half], own[tile][half]);
      }
    }
  };
  const std::uint32_t is_of_pilot = lacks_pilot() ? 1 : 0;
  std::vector<RenderedPart> divisions;
  for (RenderedPart rendered : sum_.parts) {
    rendered.part.index = 0;
    const bool is_known = std::ranges::find(divisions, rendered) != divisions.end();
    if (rendered.is_of_pilot == is_of_pilot && !is_known) divisions.push_back(rendered);
  }
  // Of an adaptive image, or a pilot, the rest is no range of samples.
  if (divisions.empty() && sum_.is_adaptive != 0) divisions.push_back({{}, is_of_pilot});
  for (RenderedPart division : divisions) {
    for (; division.part.index < division.part.count; ++division.part.index) {
      if (std::ranges::all_of(lacking, is_empty)) return missing;
      if (std::ranges::find(sum_.parts, division) == sum_.parts.end()) take(division);
    }
  }
  for (const ImagePart& part : parts_of(lacking)) missing.push_back(part);
  return missing;
}

}  // namespace transport
