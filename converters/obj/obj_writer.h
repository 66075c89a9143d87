#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

/// Replaces the OBJ file, and the library of its materials beside it (the same name with `.mtl`) if there are
/// any; or leaves both as they were and says why. What is lost is said in one warning a kind.
bool write_obj(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace convert
