#include "renderer/bake/part_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

namespace bake {
namespace {

using transport::ExactRgbSum;

constexpr transport::CheckpointKind PartKind = {
    {'G', 'R', 'F', 'B', 'P', 'T', '0', '1'}, "part of a bake", "part file", "cannot use the part file"};

/// The file's contents start with this header; the description, the parts, and the numbers of the vertices
/// with samples follow, then their tallies, and then their sums.
struct PartHeader {
  std::uint64_t samples = 0;
  std::uint64_t vertices = 0;  ///< of the bake
  std::uint64_t sums_per_vertex = 0;
  std::uint64_t description_bytes = 0;
  std::uint64_t parts = 0;
  std::uint64_t sampled_vertices = 0;
};
static_assert(std::is_trivially_copyable_v<PartHeader> && sizeof(PartHeader) == 6 * 8 &&
                  std::is_trivially_copyable_v<BakedPart> && sizeof(BakedPart) == 2 * 4 + 8 + 6 * 8,
              "the file has no gaps of unknown content");

bool has_samples(const BakeTally& tally) { return tally.counts[0] > 0; }

std::uint64_t sample_count(const BakeTally& tally) {
  return std::uint64_t(tally.counts[0]) + tally.counts[1];
}

auto sums_of(const VertexPart& part, std::size_t vertex) {
  return part.sums.begin() + static_cast<std::ptrdiff_t>(vertex * part.sums_per_vertex);
}

bool put_part(const VertexPart& part, const grf::FileWriter& write) {
  std::vector<std::uint32_t> numbers;
  std::vector<BakeTally> tallies;
  for (std::size_t i = 0; i < part.tallies.size(); ++i) {
    if (!has_samples(part.tallies[i])) continue;
    numbers.push_back(static_cast<std::uint32_t>(i));
    tallies.push_back(part.tallies[i]);
  }
  const PartHeader header{part.samples,         part.tallies.size(),
                          part.sums_per_vertex, part.description.size(),
                          part.parts.size(),    numbers.size()};
  const auto put_sums = [&](std::uint32_t vertex) {
    const std::vector<ExactRgbSum> sums(
        sums_of(part, vertex), sums_of(part, vertex) + static_cast<std::ptrdiff_t>(part.sums_per_vertex));
    return write(transport::bytes_of_all(sums));
  };
  return write(transport::bytes_of(header)) && write(part.description) &&
         write(transport::bytes_of_all(part.parts)) && write(transport::bytes_of_all(numbers)) &&
         write(transport::bytes_of_all(tallies)) && std::ranges::all_of(numbers, put_sums);
}

/// Returns whether a file of this size can have what its header says.
bool is_possible(const PartHeader& header, std::size_t rest) {
  constexpr std::uint64_t Most = std::uint64_t(1) << 32U;
  const std::array counts = {header.vertices, header.sums_per_vertex, header.description_bytes, header.parts,
                             header.sampled_vertices};
  if (std::ranges::any_of(counts, [](std::uint64_t count) { return count >= Most; })) return false;
  if (header.sums_per_vertex == 0 || header.sampled_vertices > header.vertices) return false;
  if (header.vertices > 0 && header.sums_per_vertex > Most / header.vertices) return false;
  const std::uint64_t bytes_per_vertex =
      sizeof(std::uint32_t) + sizeof(BakeTally) + header.sums_per_vertex * sizeof(ExactRgbSum);
  return header.description_bytes + header.parts * sizeof(BakedPart) +
             header.sampled_vertices * bytes_per_vertex ==
         rest;
}

std::optional<VertexPart> part_in(std::string_view bytes) {
  PartHeader header;
  if (bytes.size() < sizeof(header)) return std::nullopt;
  transport::take(bytes, &header, 1);
  if (!is_possible(header, bytes.size())) return std::nullopt;
  VertexPart part;
  part.samples = header.samples;
  part.sums_per_vertex = header.sums_per_vertex;
  part.description.resize(header.description_bytes);
  transport::take(bytes, part.description.data(), part.description.size());
  part.parts.resize(header.parts);
  transport::take(bytes, part.parts.data(), part.parts.size());
  if (part.parts.empty() || !std::ranges::all_of(part.parts, [](const BakedPart& baked) {
        return baked.part.index < baked.part.count;
      }))
    return std::nullopt;
  std::vector<std::uint32_t> numbers(header.sampled_vertices);
  transport::take(bytes, numbers.data(), numbers.size());
  if (!std::ranges::all_of(numbers, [&](std::uint32_t number) { return number < header.vertices; }))
    return std::nullopt;
  std::vector<BakeTally> tallies(numbers.size());
  transport::take(bytes, tallies.data(), tallies.size());
  part.tallies.resize(header.vertices);
  part.sums.resize(header.vertices * header.sums_per_vertex);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    part.tallies[numbers[i]] = tallies[i];
    transport::take(bytes, &part.sums[numbers[i] * header.sums_per_vertex], header.sums_per_vertex);
  }
  return part;
}

bool are_same(const BakedPart& a, const BakedPart& b) {
  return a.part == b.part && a.is_of_pilot == b.is_of_pilot;
}

void add_missing(const std::vector<BakedPart>& more, std::vector<BakedPart>& parts) {
  for (const BakedPart& one : more) {
    if (std::ranges::none_of(parts, [&](const BakedPart& known) { return are_same(known, one); }))
      parts.push_back(one);
  }
}

}  // namespace

VertexPart part_of(const Bake& bake, const transport::Fingerprint& fingerprint,
                   std::vector<BakedPart> before) {
  const BakePart own = bake.settings().part.value_or(BakePart());
  VertexPart part;
  part.fingerprint = fingerprint;
  part.samples = static_cast<std::uint64_t>(bake.settings().samples);
  part.sums_per_vertex = bake.sums_per_vertex();
  const bool is_of_pilot = before.empty();
  add_missing({{own, is_of_pilot ? 1U : 0U, bake.totals()}}, before);
  part.parts = std::move(before);
  part.tallies.resize(bake.vertex_count());
  part.sums.resize(bake.vertex_count() * part.sums_per_vertex);
  std::vector<ExactRgbSum> sums;
  for (std::size_t i = own.index; i < bake.vertex_count(); i += own.count) {
    bake.copy_vertex(i, part.tallies[i], sums);
    std::copy(sums.begin(), sums.end(),
              part.sums.begin() + static_cast<std::ptrdiff_t>(i * part.sums_per_vertex));
  }
  return part;
}

bool restore(const VertexPart& part, Bake& bake) {
  if (part.tallies.size() != bake.vertex_count() || part.sums_per_vertex != bake.sums_per_vertex())
    return false;
  std::vector<ExactRgbSum> sums;
  for (std::size_t i = 0; i < part.tallies.size(); ++i) {
    sums.assign(sums_of(part, i), sums_of(part, i) + static_cast<std::ptrdiff_t>(part.sums_per_vertex));
    bake.restore_vertex(i, part.tallies[i], sums);
  }
  return true;
}

bool write_part(const std::string& path, const VertexPart& part, grf::Diagnostics& diagnostics) {
  const auto fill = [&](const grf::FileWriter& write) { return put_part(part, write); };
  return transport::write_checkpoint_frame(path, PartKind, part.fingerprint, fill, diagnostics);
}

std::optional<VertexPart> read_part(const std::string& path, grf::Diagnostics& diagnostics) {
  const auto contents = transport::read_checkpoint_frame(path, PartKind, diagnostics);
  if (!contents) return std::nullopt;
  auto part = part_in(contents->bytes);
  if (part) {
    part->fingerprint = contents->fingerprint;
  } else {
    transport::refuse_checkpoint(path, PartKind, "it is damaged (its contents contradict each other)",
                                 diagnostics);
  }
  return part;
}

bool is_part_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, PartKind.magic.size()> magic = {};
  return file.read(magic.data(), magic.size()) && magic == PartKind.magic;
}

bool PartMerge::fits(const VertexPart& part, const std::string& path, grf::Diagnostics& diagnostics) const {
  const auto refuse = [&](std::string_view what) {
    diagnostics.error(grf::whole_file(path),
                      fmt::format("it is no part of the bake that '{}' is of: {}", paths_.front(), what));
    return false;
  };
  if (part.fingerprint.files != sum_.fingerprint.files) return refuse("the scene has other contents");
  if (part.fingerprint.options != sum_.fingerprint.options) return refuse("it has other options");
  if (part.samples != sum_.samples)
    return refuse(fmt::format("it has {} samples per vertex, and that one {}", part.samples, sum_.samples));
  if (part.fingerprint.program != sum_.fingerprint.program) return refuse("it is of another build of bpt");
  if (part.tallies.size() != sum_.tallies.size() || part.sums_per_vertex != sum_.sums_per_vertex)
    return refuse("it has other vertices");
  for (std::size_t i = 0; i < part.tallies.size(); ++i) {
    if (!has_samples(part.tallies[i]) || sample_count(part.tallies[i]) != sample_count(sum_.tallies[i]))
      continue;
    if (std::equal(sums_of(part, i), sums_of(part, i) + static_cast<std::ptrdiff_t>(part.sums_per_vertex),
                   sums_of(sum_, i)))
      continue;
    diagnostics.error(grf::whole_file(path),
                      fmt::format("vertex {} has other values than in '{}'", i, paths_[origins_[i]]));
    return false;
  }
  return true;
}

bool PartMerge::add(const VertexPart& part, const std::string& path, grf::Diagnostics& diagnostics) {
  if (paths_.empty()) {
    sum_ = part;
    origins_.resize(part.tallies.size());
    paths_.push_back(path);
    return true;
  }
  if (!fits(part, path, diagnostics)) return false;
  add_missing(part.parts, sum_.parts);
  for (std::size_t i = 0; i < part.tallies.size(); ++i) {
    if (sample_count(part.tallies[i]) <= sample_count(sum_.tallies[i])) continue;
    sum_.tallies[i] = part.tallies[i];
    std::copy(sums_of(part, i), sums_of(part, i) + static_cast<std::ptrdiff_t>(part.sums_per_vertex),
              sum_.sums.begin() + static_cast<std::ptrdiff_t>(i * part.sums_per_vertex));
    origins_[i] = static_cast<std::uint32_t>(paths_.size());
  }
  paths_.push_back(path);
  return true;
}

std::vector<BakePart> PartMerge::missing(bool is_of_pilot) const {
  std::vector<BakePart> there;
  for (const BakedPart& baked : sum_.parts) {
    if ((baked.is_of_pilot != 0) == is_of_pilot) there.push_back(baked.part);
  }
  const std::uint32_t count = there.empty() ? sum_.parts.front().part.count : there.front().count;
  std::vector<bool> is_missing(count);
  for (std::size_t vertex = 0; vertex < sum_.tallies.size(); ++vertex) {
    if (std::ranges::none_of(there, [&](const BakePart& part) { return part.has(vertex); }))
      is_missing[vertex % count] = true;
  }
  std::vector<BakePart> missing;
  for (std::uint32_t index = 0; index < count; ++index) {
    if (is_missing[index]) missing.push_back({index, count});
  }
  return missing;
}

std::vector<BakePart> PartMerge::missing() const {
  std::vector<BakePart> missing_pilot = missing(true);
  const bool is_pilot_all = std::cmp_less_equal(sum_.samples, Bake::PilotSamples);
  return is_pilot_all || !missing_pilot.empty() ? missing_pilot : missing(false);
}

}  // namespace bake
