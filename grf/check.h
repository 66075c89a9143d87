// `check` validates a scene that was read: it reports errors, and warns about likely mistakes of its author.
#pragma once

#include <set>
#include <string>

#include "grf/catalogue.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace grf {

/// Validates a scene: reports invalid models (`check` of `catalogue.h`), undefined references, negative
/// colours and radiances; and, as warnings, likely mistakes: colours over 1, faces without a BRDF, textures
/// without an image or uv, unused definitions, irradiance without an observer, degenerate faces, normals that
/// point away from the front of their face, lights that face nothing. Images whose paths are in
/// `images_to_come` may be missing. Returns false if there was an error.
bool check(const Scene& scene, const Catalogue& catalogue, Diagnostics& diagnostics,
           const std::set<std::string>& images_to_come = {});

}  // namespace grf
