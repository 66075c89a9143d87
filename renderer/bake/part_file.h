// A part file has some of the vertices of a bake, and several make the bake that one process would.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/bake/bake.h"
#include "renderer/transport/checkpoint_frame.h"

namespace bake {

/// A part that was baked.
struct BakedPart {
  BakePart part;
  std::uint64_t is_of_pilot = 0;
  transport::RenderTotals totals;  ///< of this part alone
};

/// Some of the vertices of a bake, with their samples.
struct VertexPart {
  transport::Fingerprint fingerprint;  ///< of the bake
  std::uint64_t samples = 0;           ///< mean per vertex of the whole bake
  std::uint64_t sums_per_vertex = 0;
  std::string description;                   ///< of the bake, in the format of whoever wrote it
  std::vector<BakedPart> parts;              ///< of which this consists, with the pilot of its vertices
  std::vector<BakeTally> tallies;            ///< of all vertices; without samples where the part has none
  std::vector<transport::ExactRgbSum> sums;  ///< of all vertices
};

/// Returns what a bake of a part that has run has, after the parts that it began with; without description.
VertexPart part_of(const Bake& bake, const transport::Fingerprint& fingerprint,
                   std::vector<BakedPart> before);

/// Begins a bake that has not run yet with what a part has of its vertices. False if it has others.
bool restore(const VertexPart& part, Bake& bake);

/// Replaces the file with a part, or leaves it unchanged and reports why.
bool write_part(const std::string& path, const VertexPart& part, grf::Diagnostics& diagnostics);

/// Reads a part; a damaged or altered file is an error.
std::optional<VertexPart> read_part(const std::string& path, grf::Diagnostics& diagnostics);

/// Returns whether a file begins as part files of bakes do.
bool is_part_file(const std::string& path);

/// Puts parts of one bake together.
class PartMerge {
 public:
  /// Adds a part that was read from this file. Equal vertices may be in several files. Errors name both
  /// files: another bake, and the same samples with other values.
  bool add(const VertexPart& part, const std::string& path, grf::Diagnostics& diagnostics);

  /// All vertices so far; there must be one part.
  const VertexPart& sum() const { return sum_; }

  /// Returns the parts that lack; while the pilot is incomplete, parts of the pilot. They are those of a
  /// division of which there are other parts.
  std::vector<BakePart> missing() const;

 private:
  bool fits(const VertexPart& part, const std::string& path, grf::Diagnostics& diagnostics) const;
  std::vector<BakePart> missing(bool is_of_pilot) const;

  VertexPart sum_;
  std::vector<std::string> paths_;
  std::vector<std::uint32_t> origins_;  ///< the path of each vertex
};

}  // namespace bake
