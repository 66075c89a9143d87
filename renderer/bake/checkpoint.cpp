#include "renderer/bake/checkpoint.h"

#include <filesystem>
#include <type_traits>

#include <fmt/format.h>

namespace bake {
namespace {

using transport::Fingerprint;
using transport::take;

constexpr transport::CheckpointKind BakeKind = {{'G', 'R', 'F', 'B', 'A', 'K', '0', '3'}, "bake"};

/// The file's contents start with this header; each vertex's tally and sums follow, then an `End`.
struct BakeHeader {
  std::uint64_t vertices = 0;
  std::uint64_t sums_per_vertex = 0;
};

/// Read from the bake after all vertices: so no vertex is beyond this stage, and samples that some lack of
/// earlier stages are made up for.
struct End {
  std::int64_t stage = 0;
  transport::RenderTotals totals;
};
static_assert(std::is_trivially_copyable_v<BakeHeader> && sizeof(BakeHeader) == 2 * 8 &&
                  std::is_trivially_copyable_v<End> && sizeof(End) == 8 + 6 * 8,
              "the file has no gaps of unknown content");
static_assert(std::is_trivially_copyable_v<BakeTally> && sizeof(BakeTally) == 40);

std::size_t bytes_per_vertex(const Bake& bake) {
  return sizeof(BakeTally) + bake.sums_per_vertex() * sizeof(transport::ExactRgbSum);
}

/// Returns the number of samples of all vertices together.
std::uint64_t count_samples(std::string_view bytes, const Bake& bake) {
  std::uint64_t samples = 0;
  for (std::size_t i = 0; i < bake.vertex_count(); ++i) {
    BakeTally tally;
    std::string_view rest = bytes.substr(i * bytes_per_vertex(bake));
    take(rest, &tally, 1);
    samples += std::uint64_t(tally.counts[0]) + tally.counts[1];
  }
  return samples;
}

void restore_vertices(std::string_view bytes, Bake& bake) {
  BakeTally tally;
  std::vector<transport::ExactRgbSum> sums(bake.sums_per_vertex());
  for (std::size_t i = 0; i < bake.vertex_count(); ++i) {
    take(bytes, &tally, 1);
    take(bytes, sums.data(), sums.size());
    bake.restore_vertex(i, tally, sums);
  }
}

}  // namespace

bool write_checkpoint(const std::string& path, const Fingerprint& fingerprint, const Bake& bake,
                      grf::Diagnostics& diagnostics) {
  const auto fill = [&](const grf::FileWriter& write) {
    if (!write(transport::bytes_of(BakeHeader{bake.vertex_count(), bake.sums_per_vertex()}))) return false;
    BakeTally tally;
    std::vector<transport::ExactRgbSum> sums;
    for (std::size_t i = 0; i < bake.vertex_count(); ++i) {
      bake.copy_vertex(i, tally, sums);
      if (!write(transport::bytes_of(tally)) || !write(transport::bytes_of_all(sums))) return false;
    }
    return write(transport::bytes_of(End{bake.stage(), bake.totals()}));
  };
  return transport::write_checkpoint_frame(path, BakeKind, fingerprint, fill, diagnostics);
}

bool resume_from_checkpoint(const std::string& path, const Fingerprint& fingerprint, Bake& bake,
                            grf::Diagnostics& diagnostics) {
  if (!std::filesystem::exists(path)) return true;
  const auto contents = transport::read_checkpoint_frame(path, BakeKind, fingerprint, diagnostics);
  if (!contents) return false;
  const auto refuse = [&](const std::string& why) {
    transport::refuse_checkpoint(path, BakeKind, why, diagnostics);
    return false;
  };
  std::string_view rest = contents->bytes;
  if (rest.size() < sizeof(BakeHeader)) return refuse("it is damaged (unexpected end of file)");
  BakeHeader header;
  take(rest, &header, 1);
  if (header.vertices != bake.vertex_count() || header.sums_per_vertex != bake.sums_per_vertex()) {
    return refuse(transport::mismatch_reason(BakeKind, "with other options"));
  }
  const std::size_t vertex_bytes = bake.vertex_count() * bytes_per_vertex(bake);
  if (rest.size() != vertex_bytes + sizeof(End)) return refuse("it is damaged (wrong file size)");
  End end;
  std::string_view last = rest.substr(vertex_bytes);
  take(last, &end, 1);
  end.totals.paths = count_samples(rest, bake);
  const double samples = static_cast<double>(end.totals.paths) / bake.baked_vertex_count();
  // Counts of vertices are rounded, by half a sample in each half.
  if (samples > bake.settings().samples + 1.0) {
    return refuse(fmt::format("it has {:.0f} samples per vertex, more than the {} requested", samples,
                              bake.settings().samples));
  }
  restore_vertices(rest, bake);
  bake.restore(static_cast<int>(end.stage), end.totals);
  return true;
}

}  // namespace bake
