#include "renderer/transport/checkpoint.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <type_traits>

#include <fmt/format.h>
#include <zlib.h>

#include "grf/text_file.h"

namespace transport {
namespace {

// The file: this header, each tile's counts and sums in the order of the film, and the check sum of all that.
// Numbers are little-endian, as those of the machines that we build for.
static_assert(std::endian::native == std::endian::little);

constexpr std::array<char, 8> Magic = {'G', 'R', 'F', 'C', 'H', 'K', '0', '1'};

struct Header {
  std::array<char, 8> magic = Magic;
  Fingerprint fingerprint;
  std::uint32_t tile_size = Film::TileSize;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  RenderTotals totals;
};
static_assert(std::is_trivially_copyable_v<Header> && sizeof(Header) == 8 + 6 * 4 + 6 * 8,
              "the file has no gaps of unknown content");

template <class T>
std::string_view bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

std::string_view bytes_of(const std::vector<FilmTile::PixelSums>& sums) {
  return {reinterpret_cast<const char*>(sums.data()), sums.size() * sizeof(sums[0])};
}

constexpr std::size_t PixelBytes = sizeof(FilmTile::PixelSums);
static_assert(PixelBytes == 48);

/// As a checkpoint of this render starts.
Header header_of(const Render& render, const Fingerprint& fingerprint) {
  Header header;
  header.fingerprint = fingerprint;
  header.width = static_cast<std::uint32_t>(render.settings().width);
  header.height = static_cast<std::uint32_t>(render.settings().height);
  header.totals = render.totals();
  return header;
}

std::size_t size_of_file(const Film& film) {
  const std::size_t pixels = static_cast<std::size_t>(film.width()) * static_cast<std::size_t>(film.height());
  const std::size_t counts = static_cast<std::size_t>(film.tile_count()) * sizeof(FilmTile::Counts);
  return sizeof(Header) + counts + pixels * PixelBytes + sizeof(std::uint32_t);
}

/// Takes values off the front of bytes that are known to be long enough.
template <class T>
void take(std::string_view& bytes, T* values, std::size_t count) {
  std::memcpy(static_cast<void*>(values), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
}

/// What is wrong with a file as such, or nothing.
std::string defect_of(std::string_view bytes) {
  if (bytes.size() < sizeof(Magic) || std::memcmp(bytes.data(), Magic.data(), sizeof(Magic)) != 0) {
    return "it is no checkpoint of this version of bpt";
  }
  if (bytes.size() < sizeof(Header) + sizeof(std::uint32_t)) return "it is broken (it ends early)";
  const std::size_t content = bytes.size() - sizeof(std::uint32_t);
  std::uint32_t expected = 0;
  std::memcpy(&expected, bytes.data() + content, sizeof(expected));
  return check_sum(0, bytes.substr(0, content)) == expected
             ? ""
             : "it is broken (it ends early, or its bytes were changed)";
}

/// What makes it another image's, or nothing.
std::string difference_between(const Header& found, const Header& expected) {
  const auto because = [](std::string_view what) {
    return fmt::format("it belongs to a render {}; remove it, or name another file, to start anew", what);
  };
  if (found.fingerprint.files != expected.fingerprint.files) return because("of a scene with other contents");
  if (found.fingerprint.options != expected.fingerprint.options || found.width != expected.width ||
      found.height != expected.height || found.tile_size != expected.tile_size) {
    return because("with other options");
  }
  if (found.fingerprint.program != expected.fingerprint.program) return because("by another build of bpt");
  return "";
}

/// The most samples that a pixel has.
std::uint32_t most_samples(std::string_view tiles, const Film& film) {
  std::uint32_t most = 0;
  for (int i = 0; i < film.tile_count(); ++i) {
    FilmTile::Counts counts;
    take(tiles, counts.data(), counts.size());
    most = std::max(most, counts[0] + counts[1]);
    tiles.remove_prefix(film.bounds_of(i).pixel_count() * PixelBytes);
  }
  return most;
}

/// Gives back how many paths that was.
std::uint64_t restore_tiles(std::string_view tiles, Render& render) {
  std::uint64_t paths = 0;
  FilmTile tile;
  for (int i = 0; i < render.film().tile_count(); ++i) {
    tile.bounds = render.film().bounds_of(i);
    tile.pixels.resize(tile.bounds.pixel_count());
    take(tiles, tile.counts.data(), tile.counts.size());
    take(tiles, tile.pixels.data(), tile.pixels.size());
    render.restore_tile(i, tile);
    paths += tile.sample_count() * tile.bounds.pixel_count();
  }
  return paths;
}

}  // namespace

std::uint32_t check_sum(std::uint32_t before, std::string_view bytes) {
  return static_cast<std::uint32_t>(
      ::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

bool write_checkpoint(const std::string& path, const Fingerprint& fingerprint, const Render& render,
                      grf::Diagnostics& diagnostics) {
  const auto fill = [&](const grf::FileWriter& write) {
    std::uint32_t sum = 0;
    const auto put = [&](std::string_view bytes) {
      sum = check_sum(sum, bytes);
      return write(bytes);
    };
    if (!put(bytes_of(header_of(render, fingerprint)))) return false;
    FilmTile tile;
    for (int i = 0; i < render.film().tile_count(); ++i) {
      render.copy_tile(i, tile);
      if (!put(bytes_of(tile.counts)) || !put(bytes_of(tile.pixels))) return false;
    }
    return write(bytes_of(sum));
  };
  return grf::replace_file(path, fill, diagnostics);
}

bool resume_from_checkpoint(const std::string& path, const Fingerprint& fingerprint, Render& render,
                            grf::Diagnostics& diagnostics) {
  if (!std::filesystem::exists(path)) return true;
  const auto bytes = grf::map_file(path, diagnostics);
  if (!bytes) return false;
  const auto refuse = [&](const std::string& why) {
    diagnostics.error(grf::whole_file(path), "cannot resume from the checkpoint: " + why);
    return false;
  };
  if (const std::string defect = defect_of(*bytes); !defect.empty()) return refuse(defect);
  std::string_view rest = *bytes;
  Header header;
  take(rest, &header, 1);
  const std::string difference = difference_between(header, header_of(render, fingerprint));
  if (!difference.empty()) return refuse(difference);
  if (bytes->size() != size_of_file(render.film())) return refuse("it is broken (its size is wrong)");
  const std::uint32_t samples = most_samples(rest, render.film());
  if (samples > static_cast<std::uint32_t>(render.settings().samples)) {
    return refuse(fmt::format("it has {} samples a pixel, more than the {} that are asked for", samples,
                              render.settings().samples));
  }
  header.totals.paths = restore_tiles(rest, render);  // workers may have gone on since the header was written
  render.restore(header.totals);
  return true;
}

}  // namespace transport
