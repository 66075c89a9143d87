#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "grf/math.h"
#include "grf/model.h"
#include "grf/source_location.h"

namespace grf {

using ColourAttribute = std::variant<Colour, Reference>;
using BrdfAttribute = std::variant<BrdfModel, Reference>;
using PdfAttribute = std::variant<PdfModel, Reference>;
using TextureAttribute = std::variant<Texture, Reference>;

/// The surface attributes that faces share. An absent attribute was not given, and its default holds: colour
/// 1, BRDF diffuse with kd = 0.5, the BRDF's own sampling scheme, no texture, no emission.
struct Surface {
  std::optional<ColourAttribute> colour;
  std::optional<BrdfAttribute> brdf;
  std::optional<PdfAttribute> pdf;
  std::optional<TextureAttribute> texture;
  std::optional<Colour> emission;  ///< radiance from the front, W/(sr m2)
  SourceLocation location;         ///< the attributes of the first run of faces with this surface

  bool operator==(const Surface&) const = default;
};

/// Computes a hash; equal surfaces have equal hashes.
std::size_t hash_value(const Surface& surface);

/// Returns a key that two surfaces share if they are equal and have the same text too: the same sign of each
/// zero and the same case of each keyword.
std::string written_key(const Surface& surface);

}  // namespace grf
