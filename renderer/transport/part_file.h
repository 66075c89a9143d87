// A part file has some of the samples of an image.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/transport/checkpoint_frame.h"
#include "renderer/transport/digest.h"
#include "renderer/transport/render.h"
#include "renderer/transport/sample_intervals.h"

namespace transport {

/// A part that was rendered.
struct RenderedPart {
  ImagePart part;
  std::uint32_t is_of_pilot = 0;  ///< whether it is one of the pilot of an adaptive image

  bool operator==(const RenderedPart&) const = default;
};

/// The samples of a tile that a part has, and their sums.
struct PartTile {
  std::array<SampleIntervals, FilmTile::Scramblings> samples;  ///< by half
  std::array<double, FilmTile::Scramblings> spreads = {};      ///< as in FilmTile; 0 without the pilot
  std::vector<FilmTile::PixelSums> pixels;                     ///< empty if there are no samples

  bool is_empty() const { return samples[0].empty() && samples[1].empty(); }
  /// Whether it has the first sample of the first half.
  bool has_first_sample() const { return !samples[0].empty() && samples[0].front().first == 0; }
};

/// Some of the samples of an image.
struct SamplePart {
  Fingerprint fingerprint;  ///< of the image
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t image_samples = 0;  ///< per pixel of the whole image
  std::uint32_t is_adaptive = 0;    ///< whether the image is sampled adaptively
  RenderTotals totals;
  /// Metadata of the image, in the format of whoever wrote it. Of several parts, the part with the
  /// first sample of the first tile has the one that counts.
  std::string description;
  std::vector<RenderedPart> parts;  ///< of which this is the sum
  std::vector<PartTile> tiles;      ///< in the order of Film
};

/// Returns what a render that has run has of its image, whose pixels have this many samples; without
/// description.
SamplePart part_of(const Render& render, const Fingerprint& fingerprint, int image_samples);

/// Replaces the file with a part, or leaves it unchanged and reports why.
bool write_part(const std::string& path, const SamplePart& part, grf::Diagnostics& diagnostics);

/// Reads a part; a damaged or altered file is an error.
std::optional<SamplePart> read_part(const std::string& path, grf::Diagnostics& diagnostics);

/// Returns the bytes of a part's file.
std::string bytes_of(const SamplePart& part);

/// Reads these bytes likewise; messages name where they come from.
std::optional<SamplePart> parse_part(std::string bytes, const std::string& origin,
                                     grf::Diagnostics& diagnostics);

/// Returns the digest of the numbers of a part's samples and of their sums: all that a machine computes.
Digest digest_of(const SamplePart& part);

}  // namespace transport
