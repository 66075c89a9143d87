// What is wrong with a scene that could be read, and what its author may not have meant.
#pragma once

#include <set>
#include <string>

#include "grf/catalogue.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace grf {

/// Reports models that are not right (`check` of `catalogue.h`), references that name nothing, colours and
/// radiances under 0; and, as warnings, what an author may not have meant: colours over 1, faces without a
/// BRDF, textures without an image or uv, definitions that nothing uses, irradiance without an observer,
/// faces without area, normals behind their faces, lights that face nothing. Images whose paths are in
/// `images_to_come` are not missed. Returns false if there was an error.
bool check(const Scene& scene, const Catalogue& catalogue, Diagnostics& diagnostics,
           const std::set<std::string>& images_to_come = {});

}  // namespace grf
