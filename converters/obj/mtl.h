#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "converters/material_mapping.h"
#include "converters/material_rule.h"
#include "converters/obj/mtl_image.h"
#include "grf/diagnostics.h"

namespace convert {

/// The exact surface attributes in the comments `# grf: BRDF` and `# grf rgb: (R, G, B)` of a material, which
/// our MTL writer adds.
struct ExactSurface {
  std::optional<grf::BrdfModel> brdf;  ///< empty if the comment says `none`: the faces have no BRDF
  std::optional<grf::Colour> colour;
};

/// A material of a library. Its image is relative to the library's folder.
struct MtlMaterial {
  PhongMaterial phong;
  UvTransform uv;
  std::optional<ExactSurface> exact;
};

/// Reads the materials of an MTL library, in order; names may repeat. Invalid values and a library that
/// cannot be read are only warnings, since the geometry does not depend on it. `asked_for_at` is the location
/// of the library's name.
std::vector<MtlMaterial> read_mtl(const std::string& path, const grf::SourceLocation& asked_for_at,
                                  grf::Diagnostics& diagnostics);

/// Returns the table of conversions of materials that are read.
std::span<const MaterialRule> mtl_rules();

}  // namespace convert
