#pragma once

#include <cstddef>
#include <cstdint>
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

/// How opaque faces are. Where a face is absent, light passes as if there were no face.
struct Opacity {
  /// What `value` means.
  enum class Kind : std::uint8_t {
    Number,  ///< `value` is the fraction of light that meets the face
    Mask,    ///< the face is present where the alpha of its texture is `value` or more, and absent elsewhere
    Blend    ///< the fraction is `value` times the alpha of its texture
  };

  Kind kind = Kind::Number;
  float value = 1;  ///< in [0,1]

  bool operator==(const Opacity&) const = default;

  /// Whether it depends on the alpha of the texture.
  bool reads_alpha() const { return kind != Kind::Number; }
};

/// The surface attributes that faces share. An absent attribute was not given, and its default holds: colour
/// 1, BRDF diffuse with kd = 0.5, the BRDF's own sampling scheme, no texture, no emission, opaque.
struct Surface {
  std::optional<ColourAttribute> colour;
  std::optional<BrdfAttribute> brdf;
  std::optional<PdfAttribute> pdf;
  std::optional<TextureAttribute> texture;
  std::optional<Colour> emission;  ///< radiance from the front, W/(sr m2)
  std::optional<Opacity> opacity;
  SourceLocation location;  ///< the attributes of the first run of faces with this surface

  bool operator==(const Surface&) const = default;
};

/// Computes a hash; equal surfaces have equal hashes.
std::size_t hash_value(const Surface& surface);

/// Returns a key that two surfaces share if they are equal and have the same text too: the same sign of each
/// zero and the same case of each keyword.
std::string written_key(const Surface& surface);

}  // namespace grf
