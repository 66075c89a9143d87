#include "renderer/transport/checkpoint.h"

#include <filesystem>
#include <type_traits>

#include <fmt/format.h>

namespace transport {
namespace {

constexpr CheckpointKind RenderKind = {{'G', 'R', 'F', 'C', 'H', 'K', '0', '5'}, "render"};

/// The file's contents start with this header; each tile's counts, spreads and sums follow, in the film's
/// order.
struct RenderHeader {
  std::uint32_t tile_size = Film::TileSize;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t unused = 0;
  RenderTotals totals;
};
static_assert(std::is_trivially_copyable_v<RenderHeader> && sizeof(RenderHeader) == 4 * 4 + 6 * 8,
              "the file has no gaps of unknown content");

constexpr std::size_t PixelBytes = sizeof(FilmTile::PixelSums);
static_assert(PixelBytes == 96);
/// The bytes of a tile, apart from its pixels.
constexpr std::size_t TileBytes = sizeof(FilmTile::Counts) + sizeof(FilmTile::spreads);

/// Returns the header of a checkpoint of this render.
RenderHeader header_of(const Render& render) {
  RenderHeader header;
  header.width = static_cast<std::uint32_t>(render.settings().width);
  header.height = static_cast<std::uint32_t>(render.settings().height);
  header.totals = render.totals();
  return header;
}

std::size_t size_of_contents(const Film& film) {
  const std::size_t pixels = static_cast<std::size_t>(film.width()) * static_cast<std::size_t>(film.height());
  return sizeof(RenderHeader) + static_cast<std::size_t>(film.tile_count()) * TileBytes + pixels * PixelBytes;
}

/// Returns the largest number of samples of a pixel; the mean, if the render is adaptive.
std::uint32_t samples_of(std::string_view tiles, const Render& render) {
  const Film& film = render.film();
  std::uint32_t most = 0;
  double sum = 0;
  for (int i = 0; i < film.tile_count(); ++i) {
    FilmTile::Counts counts;
    take(tiles, counts.data(), counts.size());
    const std::size_t pixels = film.bounds_of(i).pixel_count();
    most = std::max(most, counts[0] + counts[1]);
    sum += (static_cast<double>(counts[0]) + counts[1]) * static_cast<double>(pixels);
    tiles.remove_prefix(TileBytes - sizeof(counts) + pixels * PixelBytes);
  }
  const double mean = sum / (static_cast<double>(film.width()) * film.height());
  return render.settings().adaptive ? static_cast<std::uint32_t>(mean) : most;
}

/// Restores the tiles, and returns the number of their paths.
std::uint64_t restore_tiles(std::string_view tiles, Render& render) {
  std::uint64_t paths = 0;
  FilmTile tile;
  for (int i = 0; i < render.film().tile_count(); ++i) {
    tile.bounds = render.film().bounds_of(i);
    tile.pixels.resize(tile.bounds.pixel_count());
    take(tiles, tile.counts.data(), tile.counts.size());
    take(tiles, tile.spreads.data(), tile.spreads.size());
    take(tiles, tile.pixels.data(), tile.pixels.size());
    render.restore_tile(i, tile);
    paths += render.sample_count_of(i) * tile.bounds.pixel_count();
  }
  return paths;
}

}  // namespace

bool write_checkpoint(const std::string& path, const Fingerprint& fingerprint, const Render& render,
                      grf::Diagnostics& diagnostics) {
  const auto fill = [&](const grf::FileWriter& write) {
    if (!write(bytes_of(header_of(render)))) return false;
    FilmTile tile;
    for (int i = 0; i < render.film().tile_count(); ++i) {
      render.copy_tile(i, tile);
      if (!write(bytes_of(tile.counts)) || !write(bytes_of(tile.spreads)) ||
          !write(bytes_of_all(tile.pixels)))
        return false;
    }
    return true;
  };
  return write_checkpoint_frame(path, RenderKind, fingerprint, fill, diagnostics);
}

bool resume_from_checkpoint(const std::string& path, const Fingerprint& fingerprint, Render& render,
                            grf::Diagnostics& diagnostics) {
  if (!std::filesystem::exists(path)) return true;
  const auto contents = read_checkpoint_frame(path, RenderKind, fingerprint, diagnostics);
  if (!contents) return false;
  const auto refuse = [&](const std::string& why) {
    refuse_checkpoint(path, RenderKind, why, diagnostics);
    return false;
  };
  std::string_view rest = contents->bytes;
  if (rest.size() < sizeof(RenderHeader)) return refuse("it is damaged (unexpected end of file)");
  RenderHeader header;
  take(rest, &header, 1);
  const RenderHeader expected = header_of(render);
  if (header.width != expected.width || header.height != expected.height ||
      header.tile_size != expected.tile_size) {
    return refuse(mismatch_reason(RenderKind, "with other options"));
  }
  if (contents->bytes.size() != size_of_contents(render.film())) {
    return refuse("it is damaged (wrong file size)");
  }
  const std::uint32_t samples = samples_of(rest, render);
  if (samples > static_cast<std::uint32_t>(render.settings().samples)) {
    return refuse(fmt::format("it has {} samples per pixel, more than the {} requested", samples,
                              render.settings().samples));
  }
  header.totals.paths = restore_tiles(rest, render);  // workers may have continued after the header
  render.restore(header.totals);
  return true;
}

}  // namespace transport
