#include "renderer/transport/part_file.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

namespace transport {
namespace {

constexpr CheckpointKind PartKind = {
    {'G', 'R', 'F', 'P', 'R', 'T', '0', '2'}, "part", "part file", "cannot use the part file"};
constexpr auto Halves = static_cast<std::size_t>(FilmTile::Scramblings);

/// The file's contents start with this header; the description and the parts follow, and what there is of
/// each tile: the numbers of its intervals, the intervals, and unless there are none, the spreads and the
/// sums.
struct PartHeader {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t image_samples = 0;
  std::uint32_t is_adaptive = 0;
  RenderTotals totals;
  std::uint64_t parts = 0;
  std::uint64_t description_bytes = 0;
};
static_assert(std::is_trivially_copyable_v<PartHeader> && sizeof(PartHeader) == 4 * 4 + 6 * 8 + 2 * 8 &&
                  std::is_trivially_copyable_v<RenderedPart> && sizeof(RenderedPart) == 7 * 4,
              "the file has no gaps of unknown content");

/// Takes values from the front of bytes that may be too short.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  bool read(T* values, std::size_t count) {
    if (count > bytes_.size() / sizeof(T)) return false;
    take(bytes_, values, count);
    return true;
  }
  template <class T>
  bool read(std::vector<T>& values, std::size_t count) {
    if (count > bytes_.size() / sizeof(T)) return false;
    values.resize(count);
    take(bytes_, values.data(), count);
    return true;
  }
  bool is_at_end() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

bool read_tile(Reader& reader, std::size_t pixels, PartTile& tile) {
  std::array<std::uint32_t, Halves> counts = {};
  if (!reader.read(counts.data(), counts.size())) return false;
  for (std::size_t half = 0; half < Halves; ++half) {
    if (!reader.read(tile.samples[half], counts[half])) return false;
    std::uint32_t end = 0;
    for (const SampleInterval& interval : tile.samples[half]) {
      const bool follows = interval.first > end || (interval.first == 0 && end == 0);
      if (!follows || interval.end <= interval.first) return false;
      end = interval.end;
    }
  }
  return tile.is_empty() ||
         (reader.read(tile.spreads.data(), tile.spreads.size()) && reader.read(tile.pixels, pixels));
}

bool is_possible(const RenderedPart& rendered) {
  const ImagePart& part = rendered.part;
  return part.first_sample >= 0 && part.end_sample > part.first_sample && part.first_tile >= 0 &&
         part.end_tile > part.first_tile && part.index >= 0 && part.count > part.index;
}

std::optional<SamplePart> part_in(std::string_view bytes) {
  Reader reader(bytes);
  PartHeader header;
  constexpr std::uint32_t LargestSide = 1 << 20;
  if (!reader.read(&header, 1) || header.width - 1 >= LargestSide || header.height - 1 >= LargestSide ||
      header.description_bytes > bytes.size()) {
    return std::nullopt;
  }
  SamplePart part;
  part.width = header.width;
  part.height = header.height;
  part.image_samples = header.image_samples;
  part.is_adaptive = header.is_adaptive;
  part.totals = header.totals;
  part.description.resize(static_cast<std::size_t>(header.description_bytes));
  if (!reader.read(part.description.data(), part.description.size()) ||
      !reader.read(part.parts, static_cast<std::size_t>(header.parts)) ||
      !std::ranges::all_of(part.parts, is_possible)) {
    return std::nullopt;
  }
  const auto across = static_cast<int>((header.width + Film::TileSize - 1) / Film::TileSize);
  const auto down = static_cast<int>((header.height + Film::TileSize - 1) / Film::TileSize);
  for (int y = 0; y < down; ++y) {
    for (int x = 0; x < across; ++x) {
      const int width = std::min(Film::TileSize, static_cast<int>(header.width) - x * Film::TileSize);
      const int height = std::min(Film::TileSize, static_cast<int>(header.height) - y * Film::TileSize);
      part.tiles.emplace_back();
      if (!read_tile(reader, static_cast<std::size_t>(width * height), part.tiles.back()))
        return std::nullopt;
    }
  }
  return reader.is_at_end() ? std::optional(std::move(part)) : std::nullopt;
}

bool put_tile(const PartTile& tile, const grf::FileWriter& write) {
  const std::array<std::uint32_t, Halves> counts = {static_cast<std::uint32_t>(tile.samples[0].size()),
                                                    static_cast<std::uint32_t>(tile.samples[1].size())};
  return write(bytes_of(counts)) && write(bytes_of_all(tile.samples[0])) &&
         write(bytes_of_all(tile.samples[1])) &&
         (tile.is_empty() || (write(bytes_of(tile.spreads)) && write(bytes_of_all(tile.pixels))));
}

bool put_part(const SamplePart& part, const grf::FileWriter& write) {
  const PartHeader header{part.width,  part.height,       part.image_samples,     part.is_adaptive,
                          part.totals, part.parts.size(), part.description.size()};
  return write(bytes_of(header)) && write(part.description) && write(bytes_of_all(part.parts)) &&
         std::ranges::all_of(part.tiles, [&](const PartTile& tile) { return put_tile(tile, write); });
}

std::optional<SamplePart> part_of_contents(const CheckpointContents& contents, const std::string& path,
                                           grf::Diagnostics& diagnostics) {
  auto part = part_in(contents.bytes);
  if (part) {
    part->fingerprint = contents.fingerprint;
  } else {
    refuse_checkpoint(path, PartKind, "it is damaged (its contents contradict each other)", diagnostics);
  }
  return part;
}

}  // namespace

SamplePart part_of(const Render& render, const Fingerprint& fingerprint, int image_samples) {
  const RenderSettings& settings = render.settings();
  SamplePart part;
  part.fingerprint = fingerprint;
  part.width = static_cast<std::uint32_t>(render.film().width());
  part.height = static_cast<std::uint32_t>(render.film().height());
  part.totals = render.totals();
  part.image_samples = static_cast<std::uint32_t>(image_samples);
  part.is_adaptive = settings.is_adaptive() ? 1 : 0;
  const bool is_of_pilot = part.is_adaptive != 0 && settings.part_samples.empty();
  part.parts = {{settings.part.value_or(ImagePart()), is_of_pilot ? 1U : 0U}};
  part.tiles.resize(static_cast<std::size_t>(render.film().tile_count()));
  FilmTile tile;
  for (int i = 0; i < render.film().tile_count(); ++i) {
    if (render.sample_count_of(i) == 0) continue;
    render.copy_tile(i, tile);
    const auto index = static_cast<std::size_t>(i);
    const auto& all = render.part_samples();
    PartTile& own = part.tiles[index];
    for (std::size_t half = 0; half < Halves; ++half) {
      const std::uint32_t first = all.empty() ? 0 : all[index].first[half];
      if (tile.counts[half] > 0) own.samples[half] = {{first, first + tile.counts[half]}};
    }
    own.spreads = tile.spreads;
    own.pixels = std::move(tile.pixels);
  }
  return part;
}

bool write_part(const std::string& path, const SamplePart& part, grf::Diagnostics& diagnostics) {
  const auto fill = [&](const grf::FileWriter& write) { return put_part(part, write); };
  return write_checkpoint_frame(path, PartKind, part.fingerprint, fill, diagnostics);
}

std::optional<SamplePart> read_part(const std::string& path, grf::Diagnostics& diagnostics) {
  const auto contents = read_checkpoint_frame(path, PartKind, diagnostics);
  return contents ? part_of_contents(*contents, path, diagnostics) : std::nullopt;
}

std::string bytes_of(const SamplePart& part) {
  return checkpoint_frame(PartKind, part.fingerprint,
                          [&](const grf::FileWriter& write) { return put_part(part, write); });
}

std::optional<SamplePart> parse_part(std::string bytes, const std::string& origin,
                                     grf::Diagnostics& diagnostics) {
  const auto contents = parse_checkpoint_frame(std::make_shared<const std::string>(std::move(bytes)), origin,
                                               PartKind, diagnostics);
  return contents ? part_of_contents(*contents, origin, diagnostics) : std::nullopt;
}

Digest digest_of(const SamplePart& part) {
  DigestBuilder builder;
  const auto add = [&](std::string_view bytes) {
    builder.add(bytes);
    return true;
  };
  for (const PartTile& tile : part.tiles) put_tile(tile, add);
  return builder.digest();
}

}  // namespace transport
