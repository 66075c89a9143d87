// A surface comes back from another format as the format's reader has it, or by the mapping of a format that
// is only written.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "converters/format.h"
#include "grf/scene.h"
#include "grf/visit.h"
#include "renderer/reflectance/brdf.h"

namespace convert {

/// A surface's reflection without its texture, as GRF text and ready to be evaluated.
struct ReflectingSurface {
  std::string definitions;              ///< of names in the BRDF, one per line; may be empty
  std::string brdf;                     ///< as after the keyword `brdf`
  grf::BrdfModel model;                 ///< of that text
  grf::Colour colour = grf::Colour(1);  ///< a factor of the BRDF
  reflectance::Brdf made;

  /// Returns the BRDF's text with the colour and the definitions, on one line.
  std::string text() const;
};

/// Returns the reflection of a surface of a scene whose file names are absolute, or nothing after an error.
std::optional<ReflectingSurface> reflecting_surface(const grf::ResolvedSurface& surface,
                                                    grf::Diagnostics& diagnostics);

/// Converts a surface to a format that is written, and back. Formats that are not read are those of
/// renderers, whose material is taken before it becomes text, and USD and MaterialX, with the nearest
/// metallic-roughness material. `name` makes names unique, and `folder` gets files. Nothing after an error.
std::optional<ReflectingSurface> returned_surface(const ReflectingSurface& original,
                                                  const grf::ResolvedSurface& surface, const Format& format,
                                                  const std::string& name, const std::string& folder,
                                                  grf::Diagnostics& diagnostics);

}  // namespace convert
