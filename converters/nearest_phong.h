#pragma once

#include <functional>

#include "converters/material_mapping.h"
#include "grf/model.h"

namespace convert {

/// The definition that a term of `combine` names, or null.
using FindTerm = std::function<const grf::BrdfModel*(const grf::CombineTerm& term)>;

/// What comes nearest to a BRDF among the materials of the Phong family: the inverse of `map_material` where
/// the BRDF is one of those that it gives (`diffuse`, `lewis`, `specular`), exact for `phong` too, and else
/// the albedo of the diffuse part and a highlight of about the same albedo at normal incidence and the same
/// width. Name, emission and image are left as they are by default.
PhongMaterial nearest_phong(const grf::BrdfModel& brdf, const FindTerm& find_term);

}  // namespace convert
