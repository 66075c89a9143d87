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

/// What the comments `# grf: BRDF` and `# grf rgb: (R, G, B)` of a material say, which the writer of MTL puts
/// there: what its faces have, exactly.
struct ExactSurface {
  std::optional<grf::BrdfModel> brdf;  ///< none where the comment says `none`: the faces have none
  std::optional<grf::Colour> colour;
};

/// A material of a library. Its image is named from the library's folder.
struct MtlMaterial {
  PhongMaterial phong;
  UvTransform uv;
  std::optional<ExactSurface> exact;
};

/// The materials of a library of OBJ files (`.mtl`), in its order; a name may come twice. What is wrong in it
/// is said in warnings, since the faces are whole without it: values that are none, and a library that cannot
/// be read, of which `asked_for_at` is the place that names it.
std::vector<MtlMaterial> read_mtl(const std::string& path, const grf::SourceLocation& asked_for_at,
                                  grf::Diagnostics& diagnostics);

/// What becomes of materials that are read.
std::span<const MaterialRule> mtl_rules();

}  // namespace convert
